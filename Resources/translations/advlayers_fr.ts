<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>AdvLayersPreferences</name>
    <message>
        <source> deg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curvature angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Defaults of a new layer mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw the layers as they grow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each layer of a new mesh is this much higher than the one before it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces that meet at an angle below this are meshed as one patch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feature angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>General</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grow until isotropic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grows each layer of a new mesh until its height reaches the spacing along the wall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Growth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How often the growing mesh is drawn, at most.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meshing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of layers of a new mesh; 0 grows them until the fronts close.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures per second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the mesh in the 3D view while it is being made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The most that one element edge may turn along a curved edge or face.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threads to mesh with; 0 uses all processors. The mesh does not depend on it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What fills the part of a new mesh that no layer reaches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>triangles</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AdvLayers_Check</name>
    <message>
        <source>Check Mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lists what is to be said about the mesh: lost references, diagnostics, worst elements</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AdvLayers_Export</name>
    <message>
        <source>Export Mesh…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the mesh to a file with all of its quads, triangles and groups</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AdvLayers_FillVolume</name>
    <message>
        <source>Fill with Tetrahedra</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fills the inside of a closed layer mesh with tetrahedra, using Gmsh</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AdvLayers_Group</name>
    <message>
        <source>Groups the selected faces and edges under a name, for boundary conditions: the label of the new object, which may be changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Named Group</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AdvLayers_LayerMesh</name>
    <message>
        <source>Creates a quad-dominant surface mesh of the selected shape or faces, with layers along its edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer Mesh…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AdvLayers_Size</name>
    <message>
        <source>Sets the size of the mesh on the selected faces and edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AdvLayers_TakeOver</name>
    <message>
        <source>Makes a layer mesh with the sizes, boundary layers, regions and groups of the selected Gmsh mesh, and puts it in its place in the analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take over from Gmsh Mesh</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AdvLayers_ToMesh</name>
    <message>
        <source>Convert to Triangles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes a Mesh object of the layer mesh, each quad as two triangles</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AdvLayers_Update</name>
    <message>
        <source>Meshes the selected layer meshes again, or all of the document that are out of date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update Mesh</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AdvLayers_Wall</name>
    <message>
        <source>Gives the selected edges, or the edges of the selected faces, layers of their own height, growth and number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AdvancingLayers</name>
    <message>
        <source>Export Mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select faces or edges of the meshed shape first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select one Gmsh mesh first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select one layer mesh first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the layer mesh as well: there are several.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the shape to mesh, or some of its faces, first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to complain of.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label}: layer {layer}, {elements} elements, {seconds} s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>App::Property</name>
    <message>
        <source>As above, for this wall. 0: not given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As above, for this wall: a number. -1: not given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corner angles from 45 to 135 degrees [%].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each layer is this much higher than the one before it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge length of the mesh away from the layers. Default: 1/40 of the diagonal of the shape's bounding box.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge length of the mesh. 0: not given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elements turned over against the surface.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces that meet at an angle below this are meshed as one patch; layers run across the edge between them. 0 makes every CAD face a patch of its own; an STL file is meshed with 20.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the first layer, measured along the surface. Default: 1/10 of size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the height of each element of a layer is from the one asked for, relative to it; NaN for the core.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers grow from every boundary edge, as long as no Wall of the mesh says otherwise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meshes again whenever a recompute finds the mesh out of date.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nodes of the mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of layers; 0 grows them until the fronts close; "isotropic" grows each until its height reaches the spacing along the wall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of mesh edges along each of the edges. 0: not given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points of the shape that was meshed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quads among all elements [%].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quads of the mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ratio of the last mesh edge along a CAD edge to the first. 0: not given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tells this mesh from the ones before it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The CAD faces to mesh, by name, or all of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edges that the values hold for. With faces too: only on the side of those faces. Faces alone: all their boundary edges, on their side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The faces and edges of the group; the mesh groups them under its label.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The faces and edges that the size holds for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The group's name in the mesh; the label, unless another is given here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest corner angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The layer that each node was extruded in; else 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The local sizes of the mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The most that one element edge may turn along a curved edge or face; finer than size where the shape is curved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The named groups of the mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The node, counted from 0, that each node was extruded from; else -1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The object that is meshed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The object whose faces are meshed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The report of the mesh, as a job writes it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The settings that the mesh was made with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The smallest corner angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The walls of the mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The way in which the object keeps its data.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threads to mesh with; 0 uses all processors. The mesh does not depend on it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Triangles of the mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall: layers grow from the edges. Match: layers of other walls run along them. Off: neither.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What fills the part that no layer reaches: quads where they come out well, or triangles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the faces looked like when they were picked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the mesher had to say.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the references looked like when they were picked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the mesh fits the settings and the shape.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Advancing Layers</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
