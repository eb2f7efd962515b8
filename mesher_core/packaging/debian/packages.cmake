# Debian packages by CPack: the core for Python (component python) and the add-on with the command
# `advlayers` (component addon). `./dev package` builds and checks them.
set(addon_folder share/freecad/Mod/AdvancingLayers)
install(DIRECTORY App Gui Resources DESTINATION ${addon_folder} COMPONENT addon
        PATTERN "__pycache__" EXCLUDE PATTERN "*.ts" EXCLUDE)
install(FILES Init.py InitGui.py package.xml DESTINATION ${addon_folder} COMPONENT addon)
install(PROGRAMS mesher_core/packaging/debian/advlayers DESTINATION bin COMPONENT addon)

set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL python addon)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_NAME advancing-layers)
set(CPACK_PACKAGE_VENDOR "Advancing Layers")
set(CPACK_PACKAGE_CONTACT "The authors of Advancing Layers <advancing-layers@users.noreply.invalid>")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
    GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-advlayers-core)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
find_package(Python 3.9 REQUIRED COMPONENTS Interpreter)  # what mesher_core found is seen there alone
math(EXPR next_python "${Python_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_python}), python3-numpy")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
    "quad-dominant surface meshes in layers from CAD edges (core)
The meshing core of Advancing Layers as a Python module: it reads CAD files
and grows anisotropic layers of quads from the edges of their faces, on the
exact surfaces.")

set(CPACK_DEBIAN_ADDON_PACKAGE_NAME freecad-advancing-layers)
set(CPACK_DEBIAN_ADDON_PACKAGE_SECTION science)
set(CPACK_DEBIAN_ADDON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_ADDON_PACKAGE_DEPENDS
    "freecad (>= 0.20), python3, python3-numpy, python3-advlayers-core (>= ${PROJECT_VERSION}), python3-advlayers-core (<< ${PROJECT_VERSION}+~)")
set(CPACK_DEBIAN_ADDON_PACKAGE_RECOMMENDS "python3-h5py")
set(CPACK_DEBIAN_ADDON_PACKAGE_SUGGESTS "gmsh, python3-distributed, slurm-client")
set(CPACK_COMPONENT_ADDON_DESCRIPTION
    "FreeCAD workbench for quad-dominant meshes in layers from CAD edges
A workbench for FreeCAD that meshes faces of CAD models with layers of quads
that grow from their edges, and the command advlayers, which meshes a job for
every row of a table.")

# What Debian asks of every package: its licence, its changes; byte code that goes with it.
set(made ${CMAKE_BINARY_DIR}/debian)
foreach(component python addon)
  string(TOUPPER ${component} upper)
  set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  file(MAKE_DIRECTORY ${made}/${package})
  execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C date -R -r
                          ${CMAKE_SOURCE_DIR}/docs/CHANGELOG.md
                  OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  file(WRITE ${made}/${package}/changelog.Debian
       "${package} (${PROJECT_VERSION}-1) unstable; urgency=medium\n\n  * Version ${PROJECT_VERSION}; its changes are those of docs/CHANGELOG.md.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
  execute_process(COMMAND gzip -9 -n -f ${made}/${package}/changelog.Debian ERROR_QUIET)
  set(byte_code)
  if(component STREQUAL addon)  # not among Debian's own folders of Python modules
    set(byte_code /usr/${addon_folder})
  endif()
  foreach(script postinst prerm)
    configure_file(mesher_core/packaging/debian/${script}.in ${made}/${package}/${script} @ONLY
                   FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                   WORLD_READ WORLD_EXECUTE)
  endforeach()
  set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA ${made}/${package}/postinst
      ${made}/${package}/prerm)
  install(FILES ${made}/${package}/changelog.Debian.gz mesher_core/packaging/debian/copyright
          DESTINATION share/doc/${package} COMPONENT ${component})
endforeach()
file(COPY mesher_core/packaging/debian/advlayers.1 DESTINATION ${made})
execute_process(COMMAND gzip -9 -n -f ${made}/advlayers.1)
install(FILES ${made}/advlayers.1.gz DESTINATION share/man/man1 COMPONENT addon)
include(CPack)
