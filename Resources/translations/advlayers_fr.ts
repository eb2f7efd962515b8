<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>AdvLayersPreferences</name>
    <message>
        <source> deg</source>
        <translation> deg</translation>
    </message>
    <message>
        <source>Core</source>
        <translation>Cœur</translation>
    </message>
    <message>
        <source>Curvature angle</source>
        <translation>Angle de courbure</translation>
    </message>
    <message>
        <source>Defaults of a new layer mesh</source>
        <translation>Valeurs par défaut d'un nouveau maillage en couches</translation>
    </message>
    <message>
        <source>Draw the layers as they grow</source>
        <translation>Dessiner les couches pendant leur croissance</translation>
    </message>
    <message>
        <source>Each layer of a new mesh is this much higher than the one before it.</source>
        <translation>Chaque couche d'un nouveau maillage est plus haute que la précédente de ce facteur.</translation>
    </message>
    <message>
        <source>Faces that meet at an angle below this are meshed as one patch.</source>
        <translation>Les faces qui se rencontrent sous un angle plus petit sont maillées d'un seul tenant.</translation>
    </message>
    <message>
        <source>Feature angle</source>
        <translation>Angle d'arête vive</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Général</translation>
    </message>
    <message>
        <source>Grow until isotropic</source>
        <translation>Croître jusqu'à l'isotropie</translation>
    </message>
    <message>
        <source>Grows each layer of a new mesh until its height reaches the spacing along the wall.</source>
        <translation>Fait croître les couches d'un nouveau maillage jusqu'à ce que leur hauteur atteigne l'espacement le long de la paroi.</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Croissance</translation>
    </message>
    <message>
        <source>How often the growing mesh is drawn, at most.</source>
        <translation>Combien de fois au plus le maillage croissant est dessiné.</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Couches</translation>
    </message>
    <message>
        <source>Meshing</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>Number of layers of a new mesh; 0 grows them until the fronts close.</source>
        <translation>Nombre de couches d'un nouveau maillage ; avec 0, elles croissent jusqu'à ce que les fronts se ferment.</translation>
    </message>
    <message>
        <source>Pictures per second</source>
        <translation>Images par seconde</translation>
    </message>
    <message>
        <source>Shows the mesh in the 3D view while it is being made.</source>
        <translation>Montre le maillage dans la vue 3D pendant sa création.</translation>
    </message>
    <message>
        <source>The most that one element edge may turn along a curved edge or face.</source>
        <translation>De combien au plus une arête d'élément peut tourner le long d'une arête ou d'une face courbe.</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Fils d'exécution</translation>
    </message>
    <message>
        <source>Threads to mesh with; 0 uses all processors. The mesh does not depend on it.</source>
        <translation>Fils d'exécution pour mailler ; 0 utilise tous les processeurs. Le maillage n'en dépend pas.</translation>
    </message>
    <message>
        <source>What fills the part of a new mesh that no layer reaches.</source>
        <translation>Ce qui remplit la partie d'un nouveau maillage qu'aucune couche n'atteint.</translation>
    </message>
    <message>
        <source>quads</source>
        <translation>quadrangles</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>triangles</translation>
    </message>
</context>
<context>
    <name>AdvLayers_AcceptReferences</name>
    <message>
        <source>Accept References</source>
        <translation>Accepter les références</translation>
    </message>
    <message>
        <source>Takes lost references for what their names stand for now</source>
        <translation>Prend les références perdues pour ce que désignent maintenant leurs noms</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Check</name>
    <message>
        <source>Check Mesh</source>
        <translation>Vérifier le maillage</translation>
    </message>
    <message>
        <source>Opens the results of the mesh: lost references, diagnostics, worst elements; a click leads to the place</source>
        <translation>Ouvre les résultats du maillage : références perdues, messages, pires éléments ; un clic mène à l'endroit</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourBy</name>
    <message>
        <source>Colour by</source>
        <translation>Colorer selon</translation>
    </message>
    <message>
        <source>Colours the selected layer meshes, or all of the document, by one of their fields</source>
        <translation>Colore les maillages en couches sélectionnés, ou tous ceux du document, selon un de leurs champs</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourByAspectRatio</name>
    <message>
        <source>Aspect Ratio</source>
        <translation>Rapport d'aspect</translation>
    </message>
    <message>
        <source>Colours the elements by their longest side over their shortest</source>
        <translation>Colore les éléments selon le rapport de leur plus long côté au plus court</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourByDiagnostics</name>
    <message>
        <source>Diagnostics</source>
        <translation>Diagnostics</translation>
    </message>
    <message>
        <source>Shows the poor elements, and the places that the mesher's messages are about</source>
        <translation>Montre les éléments médiocres et les endroits dont parlent les messages du mailleur</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourByHeightError</name>
    <message>
        <source>Colours the elements of layers by how far their height is from the one asked for</source>
        <translation>Colore les éléments des couches selon l'écart entre leur hauteur et celle demandée</translation>
    </message>
    <message>
        <source>Height Error</source>
        <translation>Erreur de hauteur</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourByLayer</name>
    <message>
        <source>Colours the elements by the layer that they belong to</source>
        <translation>Colore les éléments selon la couche à laquelle ils appartiennent</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Couche</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourByQuality</name>
    <message>
        <source>Colours the elements by their quality, from 0 to 1</source>
        <translation>Colore les éléments selon leur qualité, de 0 à 1</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualité</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Export</name>
    <message>
        <source>Export Mesh…</source>
        <translation>Exporter le maillage…</translation>
    </message>
    <message>
        <source>Writes the mesh to a file with all of its quads, triangles and groups</source>
        <translation>Écrit le maillage dans un fichier avec tous ses quadrangles, triangles et groupes</translation>
    </message>
</context>
<context>
    <name>AdvLayers_FillVolume</name>
    <message>
        <source>Fill with Tetrahedra</source>
        <translation>Remplir de tétraèdres</translation>
    </message>
    <message>
        <source>Fills the inside of a closed layer mesh with tetrahedra, using Gmsh or Netgen</source>
        <translation>Remplit l'intérieur d'un maillage en couches fermé de tétraèdres, avec Gmsh ou Netgen</translation>
    </message>
</context>
<context>
    <name>AdvLayers_FollowReferences</name>
    <message>
        <source>Follow References</source>
        <translation>Suivre les références</translation>
    </message>
    <message>
        <source>Gives lost references the names that what was picked has now, where it is still there</source>
        <translation>Donne aux références perdues les noms que porte maintenant ce qui a été choisi, s'il est encore là</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Group</name>
    <message>
        <source>Groups the selected faces and edges under a name, for boundary conditions: the label of the new object, which may be changed</source>
        <translation>Regroupe les faces et arêtes sélectionnées sous un nom, pour les conditions aux limites : l'étiquette du nouvel objet, qui peut être modifiée</translation>
    </message>
    <message>
        <source>Named Group</source>
        <translation>Groupe nommé</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Help</name>
    <message>
        <source>Help on Advancing Layers</source>
        <translation>Aide sur Advancing Layers</translation>
    </message>
    <message>
        <source>Opens the manual: first steps, every setting, the method</source>
        <translation>Ouvre le manuel : premiers pas, chaque réglage, la méthode</translation>
    </message>
</context>
<context>
    <name>AdvLayers_LayerMesh</name>
    <message>
        <source>Creates a quad-dominant surface mesh of the selected shape or faces, with layers along its edges, or along the selected ones</source>
        <translation>Crée un maillage surfacique surtout en quadrilatères de la forme ou des faces sélectionnées, avec des couches le long de ses arêtes ou de celles sélectionnées</translation>
    </message>
    <message>
        <source>Layer Mesh…</source>
        <translation>Maillage en couches…</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Size</name>
    <message>
        <source>Sets the size of the mesh on the selected faces and edges</source>
        <translation>Fixe la taille du maillage sur les faces et arêtes sélectionnées</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
</context>
<context>
    <name>AdvLayers_TakeOver</name>
    <message>
        <source>Makes a layer mesh with the sizes, boundary layers, regions and groups of the selected Gmsh mesh, and puts it in its place in the analysis</source>
        <translation>Crée un maillage en couches avec les tailles, couches limites, régions et groupes du maillage Gmsh sélectionné, et le met à sa place dans l'analyse</translation>
    </message>
    <message>
        <source>Take over from Gmsh Mesh</source>
        <translation>Reprendre d'un maillage Gmsh</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ToMesh</name>
    <message>
        <source>Convert to Triangles</source>
        <translation>Convertir en triangles</translation>
    </message>
    <message>
        <source>Makes a Mesh object of the layer mesh, each quad as two triangles</source>
        <translation>Fait du maillage en couches un objet Mesh, de chaque quadrangle deux triangles</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Uncoloured</name>
    <message>
        <source>No Colours</source>
        <translation>Sans couleurs</translation>
    </message>
    <message>
        <source>Shows the elements in one colour, as FreeCAD shows a FEM mesh</source>
        <translation>Montre les éléments d'une seule couleur, comme FreeCAD montre un maillage FEM</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Update</name>
    <message>
        <source>Meshes the selected layer meshes again, or all of the document that are out of date</source>
        <translation>Remaille les maillages en couches sélectionnés, ou tous ceux du document qui sont obsolètes</translation>
    </message>
    <message>
        <source>Update Mesh</source>
        <translation>Actualiser le maillage</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Wall</name>
    <message>
        <source>Gives the selected edges, or the edges of the selected faces, layers of their own height, growth and number</source>
        <translation>Donne aux arêtes sélectionnées, ou aux arêtes des faces sélectionnées, des couches de hauteur, de croissance et de nombre propres</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Paroi</translation>
    </message>
</context>
<context>
    <name>AdvancingLayers</name>
    <message>
        <source>&gt; {} mm, {} of the shape's diagonal</source>
        <translation>&gt; {} mm, {} de la diagonale de la forme</translation>
    </message>
    <message>
        <source>A click shows the place; another one on the same line the next</source>
        <translation>Un clic montre l'endroit ; un autre sur la même ligne le suivant</translation>
    </message>
    <message>
        <source>A click shows where layers end too early, or where the first height is most off</source>
        <translation>Un clic montre où des couches finissent trop tôt, ou bien où la première hauteur s'écarte le plus</translation>
    </message>
    <message>
        <source>A named group of the selected faces and edges</source>
        <translation>Un groupe nommé des faces et arêtes sélectionnées</translation>
    </message>
    <message>
        <source>A range of the colours other than that of the field</source>
        <translation>Une autre étendue des couleurs que celle du champ</translation>
    </message>
    <message>
        <source>A size of their own for the selected faces, edges and vertices</source>
        <translation>Une taille propre aux faces, arêtes et sommets sélectionnés</translation>
    </message>
    <message>
        <source>Abaqus</source>
        <translation>Abaqus</translation>
    </message>
    <message>
        <source>Adds what is selected in the 3D view</source>
        <translation>Ajoute ce qui est sélectionné dans la vue 3D</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Avancé</translation>
    </message>
    <message>
        <source>All holes</source>
        <translation>Tous les trous</translation>
    </message>
    <message>
        <source>All that are not selected</source>
        <translation>Tout ce qui n'est pas sélectionné</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Toujours</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Angles from</source>
        <translation>Angles de</translation>
    </message>
    <message>
        <source>Arcs with the radius of the selected ones</source>
        <translation>Arcs du même rayon que ceux sélectionnés</translation>
    </message>
    <message>
        <source>As usual</source>
        <translation>Comme d'habitude</translation>
    </message>
    <message>
        <source>Aspect ratio</source>
        <translation>Rapport d'aspect</translation>
    </message>
    <message>
        <source>Axis direction</source>
        <translation>Direction de l'axe</translation>
    </message>
    <message>
        <source>Axis point</source>
        <translation>Point de l'axe</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Beside other meshers</source>
        <translation>À côté d'autres mailleurs</translation>
    </message>
    <message>
        <source>Both ends</source>
        <translation>Deux bouts</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Bord</translation>
    </message>
    <message>
        <source>By group</source>
        <translation>Par groupe</translation>
    </message>
    <message>
        <source>CFD: layers from all sharp edges</source>
        <translation>CFD : couches depuis toutes les arêtes vives</translation>
    </message>
    <message>
        <source>CGNS</source>
        <translation>CGNS</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Cellules</translation>
    </message>
    <message>
        <source>Cells across</source>
        <translation>Éléments en travers</translation>
    </message>
    <message>
        <source>Chord deviation</source>
        <translation>Écart de corde</translation>
    </message>
    <message>
        <source>Close the open task panel first.</source>
        <translation>Fermez d'abord le panneau de tâches ouvert.</translation>
    </message>
    <message>
        <source>Closes, and leaves everything as it was before</source>
        <translation>Ferme et laisse tout comme avant</translation>
    </message>
    <message>
        <source>Cluster</source>
        <translation>Resserrement</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Colorer selon</translation>
    </message>
    <message>
        <source>Colours from</source>
        <translation>Couleurs de</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>Core</source>
        <translation>Cœur</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Coin</translation>
    </message>
    <message>
        <source>Curvature angle</source>
        <translation>Angle de courbure</translation>
    </message>
    <message>
        <source>Cut across</source>
        <translation>Coupe suivant</translation>
    </message>
    <message>
        <source>Cutting the edges</source>
        <translation>Découpage des arêtes</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Masse volumique</translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Répartition</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Arête</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Arêtes</translation>
    </message>
    <message>
        <source>Edges as long as the selected ones</source>
        <translation>Arêtes aussi longues que celles sélectionnées</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Modifier</translation>
    </message>
    <message>
        <source>Edit Layer Mesh</source>
        <translation>Modifier le maillage en couches</translation>
    </message>
    <message>
        <source>Edit Wall, Size or Group</source>
        <translation>Modifier la paroi, la taille ou le groupe</translation>
    </message>
    <message>
        <source>Element edges</source>
        <translation>Arêtes des éléments</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>End height</source>
        <translation>Hauteur finale</translation>
    </message>
    <message>
        <source>Ended by</source>
        <translation>Terminé par</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Régulière</translation>
    </message>
    <message>
        <source>Export Mesh</source>
        <translation>Exporter le maillage</translation>
    </message>
    <message>
        <source>Extrude</source>
        <translation>Extrusion</translation>
    </message>
    <message>
        <source>FEM: no layers</source>
        <translation>EF : aucune couche</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Face edges</source>
        <translation>Bords</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Faces</translation>
    </message>
    <message>
        <source>Faces of {}</source>
        <translation>Faces de {}</translation>
    </message>
    <message>
        <source>Feature angle</source>
        <translation>Angle d'arête vive</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Finishing the core</source>
        <translation>Achèvement du cœur</translation>
    </message>
    <message>
        <source>First height</source>
        <translation>Première hauteur</translation>
    </message>
    <message>
        <source>First height from y+</source>
        <translation>Première hauteur d'après y+</translation>
    </message>
    <message>
        <source>First height {} is above the size {}: it may be {} at most</source>
        <translation>La première hauteur {} dépasse la taille {} : elle peut être de {} au plus</translation>
    </message>
    <message>
        <source>First segment</source>
        <translation>Premier segment</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Premiers pas</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Écoulement</translation>
    </message>
    <message>
        <source>Fluid</source>
        <translation>Fluide</translation>
    </message>
    <message>
        <source>Follow References</source>
        <translation>Suivre les références</translation>
    </message>
    <message>
        <source>FreeCAD document</source>
        <translation>Document FreeCAD</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Général</translation>
    </message>
    <message>
        <source>Give one of first height, aspect ratio and turning angle, not several</source>
        <translation>Donner une seule valeur parmi première hauteur, rapport d'aspect et angle de rotation</translation>
    </message>
    <message>
        <source>Gmsh</source>
        <translation>Gmsh</translation>
    </message>
    <message>
        <source>Gmsh cannot fill the mesh: it moved the nodes of the surface</source>
        <translation>Gmsh ne peut pas remplir le maillage : il a déplacé les nœuds de la surface</translation>
    </message>
    <message>
        <source>Gmsh cannot fill the mesh: {}</source>
        <translation>Gmsh ne peut pas remplir le maillage : {}</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Groupe</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Groupes</translation>
    </message>
    <message>
        <source>Growing layers</source>
        <translation>Croissance des couches</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Croissance</translation>
    </message>
    <message>
        <source>Height asked</source>
        <translation>Hauteur voulue</translation>
    </message>
    <message>
        <source>Height error [%]</source>
        <translation>Erreur de hauteur [%]</translation>
    </message>
    <message>
        <source>Height got</source>
        <translation>Hauteur obtenue</translation>
    </message>
    <message>
        <source>Help on Advancing Layers</source>
        <translation>Aide sur Advancing Layers</translation>
    </message>
    <message>
        <source>Hides what lies beyond a plane across this axis</source>
        <translation>Cache ce qui est au-delà d'un plan perpendiculaire à cet axe</translation>
    </message>
    <message>
        <source>Holes by diameter</source>
        <translation>Trous par diamètre</translation>
    </message>
    <message>
        <source>How the colours are spread over their range; logarithmic needs numbers above 0</source>
        <translation>Comment les couleurs sont réparties ; logarithmique demande des nombres au-dessus de 0</translation>
    </message>
    <message>
        <source>I-DEAS universal</source>
        <translation>I-DEAS universel</translation>
    </message>
    <message>
        <source>Initial mesh</source>
        <translation>Maillage initial</translation>
    </message>
    <message>
        <source>Inner loops of the selected faces, or of all</source>
        <translation>Contours intérieurs des faces sélectionnées, ou de toutes</translation>
    </message>
    <message>
        <source>Inp elements</source>
        <translation>Éléments .inp</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Inversés</translation>
    </message>
    <message>
        <source>It is the mesh of {}.</source>
        <translation>C'est le maillage de {}.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>Keeps the settings, and a mesh that is finished, and closes</source>
        <translation>Garde les réglages et un maillage terminé, et ferme</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Last segment</source>
        <translation>Dernier segment</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Couche</translation>
    </message>
    <message>
        <source>Layer Mesh</source>
        <translation>Maillage en couches</translation>
    </message>
    <message>
        <source>Layer groups</source>
        <translation>Groupes des couches</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Couches</translation>
    </message>
    <message>
        <source>Layers from all edges</source>
        <translation>Couches sur toutes les arêtes</translation>
    </message>
    <message>
        <source>Layers grow from the selected edges; with faces selected too, on these alone</source>
        <translation>Les couches croissent depuis les arêtes sélectionnées ; si des faces le sont aussi, sur celles-ci seulement</translation>
    </message>
    <message>
        <source>Layers run across the selected edges, however sharply their faces meet</source>
        <translation>Les couches traversent les arêtes sélectionnées, si vif que soit l’angle de leurs faces</translation>
    </message>
    <message>
        <source>Layers run along the selected edges</source>
        <translation>Les couches courent le long des arêtes sélectionnées</translation>
    </message>
    <message>
        <source>Leaves the panel open</source>
        <translation>Laisse le panneau ouvert</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmique</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>Lost references</source>
        <translation>Références perdues</translation>
    </message>
    <message>
        <source>Mapped</source>
        <translation>Réglées</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Suivre</translation>
    </message>
    <message>
        <source>Max elements</source>
        <translation>Éléments au plus</translation>
    </message>
    <message>
        <source>Max memory</source>
        <translation>Mémoire au plus</translation>
    </message>
    <message>
        <source>Max seconds</source>
        <translation>Secondes au plus</translation>
    </message>
    <message>
        <source>Medit</source>
        <translation>Medit</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Mailler</translation>
    </message>
    <message>
        <source>Mesh later</source>
        <translation>Mailler plus tard</translation>
    </message>
    <message>
        <source>Meshes what is out of date, puts the mesh into the document and closes</source>
        <translation>Maille ce qui est périmé, met le maillage dans le document et ferme</translation>
    </message>
    <message>
        <source>Meshes with the settings below; OK then puts the mesh into the document</source>
        <translation>Maille avec les réglages ci-dessous ; OK met ensuite le maillage dans le document</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Min size</source>
        <translation>Taille minimale</translation>
    </message>
    <message>
        <source>Most slivers</source>
        <translation>Cellules plates au plus</translation>
    </message>
    <message>
        <source>Msh version</source>
        <translation>Version .msh</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Nastran</source>
        <translation>Nastran</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>De près</translation>
    </message>
    <message>
        <source>Neither Gmsh nor Netgen is installed: install the package gmsh, or tell FreeCAD where it is under Edit &gt; Preferences &gt; FEM &gt; Gmsh</source>
        <translation>Ni Gmsh ni Netgen n'est installé : installez le paquet gmsh, ou indiquez à FreeCAD où il est sous Édition &gt; Préférences &gt; FEM &gt; Gmsh</translation>
    </message>
    <message>
        <source>Netgen cannot fill the mesh: {}</source>
        <translation>Netgen ne peut pas remplir le maillage : {}</translation>
    </message>
    <message>
        <source>Netgen cannot keep quads: install Gmsh, or split them</source>
        <translation>Netgen ne peut pas garder les quadrangles : installez Gmsh ou coupez-les</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Jamais</translation>
    </message>
    <message>
        <source>No layers at the selected edges</source>
        <translation>Pas de couches aux arêtes sélectionnées</translation>
    </message>
    <message>
        <source>No walls yet: with Layers from all edges, layers grow from every edge. Select edges in the 3D view and press + Wall for values of their own, + Size for finer places, + Group for boundary conditions.</source>
        <translation>Pas encore de parois : avec Couches depuis toutes les arêtes, des couches poussent depuis chaque arête. Sélectionner des arêtes dans la vue 3D et presser + Paroi pour leurs propres valeurs, + Taille pour des endroits plus fins, + Groupe pour des conditions aux limites.</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Nœuds</translation>
    </message>
    <message>
        <source>Not meshed</source>
        <translation>Non maillé</translation>
    </message>
    <message>
        <source>Nowhere</source>
        <translation>Nulle part</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Sans</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Sur</translation>
    </message>
    <message>
        <source>OpenCASCADE failed on it: {}</source>
        <translation>OpenCASCADE y a échoué : {}</translation>
    </message>
    <message>
        <source>OpenFOAM</source>
        <translation>OpenFOAM</translation>
    </message>
    <message>
        <source>OpenFOAM has no cells of second order: ask for order 1</source>
        <translation>OpenFOAM n'a pas de cellules du second ordre : demandez l'ordre 1</translation>
    </message>
    <message>
        <source>OpenFOAM needs cells: ask for extrude or volume</source>
        <translation>OpenFOAM a besoin de cellules : demandez extrude ou volume</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Autres</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Obsolète</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Sorties</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Part of {} is empty: there is nothing to mesh</source>
        <translation>Part de {} est vide : il n'y a rien à mailler</translation>
    </message>
    <message>
        <source>Patch types</source>
        <translation>Types des bords</translation>
    </message>
    <message>
        <source>Patch {patch} of {patches} · layer {layer}</source>
        <translation>Partie {patch} sur {patches} · couche {layer}</translation>
    </message>
    <message>
        <source>Periodic</source>
        <translation>Périodiques</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>Preset…</source>
        <translation>Préréglage…</translation>
    </message>
    <message>
        <source>Preview: {}</source>
        <translation>Aperçu : {}</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Puts what is there into the document and closes</source>
        <translation>Met dans le document ce qui est là et ferme</translation>
    </message>
    <message>
        <source>Python</source>
        <translation>Python</translation>
    </message>
    <message>
        <source>Quad nodes</source>
        <translation>Nœuds par quadrangle</translation>
    </message>
    <message>
        <source>Quads</source>
        <translation>Quadrangles</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualité</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Reading the shape</source>
        <translation>Lecture de la forme</translation>
    </message>
    <message>
        <source>References</source>
        <translation>Références</translation>
    </message>
    <message>
        <source>Refinements</source>
        <translation>Raffinements</translation>
    </message>
    <message>
        <source>Relative chord</source>
        <translation>Corde relative</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Removes the marked row</source>
        <translation>Retire la ligne marquée</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>STL</source>
        <translation>STL</translation>
    </message>
    <message>
        <source>SU2</source>
        <translation>SU2</translation>
    </message>
    <message>
        <source>SU2 files have plane domains (x, y or z constant) and volumes, no surfaces: {}</source>
        <translation>les fichiers SU2 ont des domaines plans (x, y ou z constant) et des volumes, pas de surfaces : {}</translation>
    </message>
    <message>
        <source>Salome MED</source>
        <translation>Salome MED</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>See through</source>
        <translation>Transparence</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segments</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Sélectionner</translation>
    </message>
    <message>
        <source>Select faces and edges in the 3D view.</source>
        <translation>Sélectionnez des faces et des arêtes dans la vue 3D.</translation>
    </message>
    <message>
        <source>Select faces or edges of the meshed shape first.</source>
        <translation>Sélectionnez d'abord des faces ou des arêtes de la forme maillée.</translation>
    </message>
    <message>
        <source>Select faces, edges and vertices in the 3D view.</source>
        <translation>Sélectionnez des faces, des arêtes et des sommets dans la vue 3D.</translation>
    </message>
    <message>
        <source>Select one Gmsh mesh first.</source>
        <translation>Sélectionnez d'abord un maillage Gmsh.</translation>
    </message>
    <message>
        <source>Select one layer mesh first.</source>
        <translation>Sélectionnez d'abord un maillage en couches.</translation>
    </message>
    <message>
        <source>Select one shape, not several ({}): a layer mesh is of one, which may be a compound.</source>
        <translation>Sélectionnez une seule forme, pas plusieurs ({}) : un maillage en couches appartient à une seule, qui peut être un composé.</translation>
    </message>
    <message>
        <source>Select the layer mesh as well: there are several.</source>
        <translation>Sélectionnez aussi le maillage en couches : il y en a plusieurs.</translation>
    </message>
    <message>
        <source>Select the shape to mesh, or some of its faces, first.</source>
        <translation>Sélectionnez d'abord la forme à mailler, ou quelques-unes de ses faces.</translation>
    </message>
    <message>
        <source>Selected: {}</source>
        <translation>Sélection : {}</translation>
    </message>
    <message>
        <source>Selects all edges of the selected faces</source>
        <translation>Sélectionne toutes les arêtes des faces sélectionnées</translation>
    </message>
    <message>
        <source>Selects holes, sharp edges, similar edges, groups</source>
        <translation>Sélectionne trous, arêtes vives, arêtes semblables, groupes</translation>
    </message>
    <message>
        <source>Selects the edges that go on from the selected ones without a corner</source>
        <translation>Sélectionne les arêtes qui prolongent celles sélectionnées sans coin</translation>
    </message>
    <message>
        <source>Selects the whole loop of the selected edges; with a face selected too, that on the face</source>
        <translation>Sélectionne toute la boucle des arêtes sélectionnées ; si une face l'est aussi, celle de la face</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Sew tolerance</source>
        <translation>Tol. de couture</translation>
    </message>
    <message>
        <source>Sharp edges</source>
        <translation>Arêtes vives</translation>
    </message>
    <message>
        <source>Shows what is behind the faces</source>
        <translation>Montre ce qui est derrière les faces</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Size growth</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Sizes</source>
        <translation>Tailles</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Lisse</translation>
    </message>
    <message>
        <source>Solvers and file formats</source>
        <translation>Solveurs et formats de fichier</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Stanford polygons</source>
        <translation>Polygones Stanford</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Stopped; the mesh is the one before.</source>
        <translation>Arrêté ; le maillage est le précédent.</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Arrêt en cours…</translation>
    </message>
    <message>
        <source>Strict</source>
        <translation>Strict</translation>
    </message>
    <message>
        <source>Takes the marked rows off the list</source>
        <translation>Retire de la liste les lignes marquées</translation>
    </message>
    <message>
        <source>Tangent</source>
        <translation>Tangente</translation>
    </message>
    <message>
        <source>The changes made here are not kept yet.</source>
        <translation>Les changements faits ici ne sont pas encore gardés.</translation>
    </message>
    <message>
        <source>The finished mesh is not in the document yet.</source>
        <translation>Le maillage terminé n'est pas encore dans le document.</translation>
    </message>
    <message>
        <source>The mesh is out of date: settings or model have changed.</source>
        <translation>Le maillage est obsolète : les réglages ou le modèle ont changé.</translation>
    </message>
    <message>
        <source>The mesher is still at work.</source>
        <translation>Le mailleur travaille encore.</translation>
    </message>
    <message>
        <source>The selected edges bound their faces, however smoothly these meet</source>
        <translation>Les arêtes sélectionnées bordent leurs faces, si lisse que soit leur raccord</translation>
    </message>
    <message>
        <source>The shape is in error: mend it first</source>
        <translation>La forme est en erreur : à réparer d'abord</translation>
    </message>
    <message>
        <source>There is no mesh yet.</source>
        <translation>Il n'y a pas encore de maillage.</translation>
    </message>
    <message>
        <source>There is no mesh yet: press Mesh.</source>
        <translation>Il n'y a pas encore de maillage : presser Mailler.</translation>
    </message>
    <message>
        <source>There is nothing to complain of.</source>
        <translation>Il n'y a rien à redire.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Thickness share</source>
        <translation>Part d'épaisseur</translation>
    </message>
    <message>
        <source>Thickness {} is below the first height {}: {} is the least</source>
        <translation>L'épaisseur {} est sous la première hauteur {} : {} est le minimum</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Fils d'exécution</translation>
    </message>
    <message>
        <source>Translation</source>
        <translation>Translation</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
    <message>
        <source>Triangulating</source>
        <translation>Triangulation</translation>
    </message>
    <message>
        <source>Turning angle</source>
        <translation>Angle de rotation</translation>
    </message>
    <message>
        <source>UGRID</source>
        <translation>UGRID</translation>
    </message>
    <message>
        <source>UGRID, big-endian</source>
        <translation>UGRID, gros-boutiste</translation>
    </message>
    <message>
        <source>UGRID, little-endian</source>
        <translation>UGRID, petit-boutiste</translation>
    </message>
    <message>
        <source>Undo would take back all of this panel.</source>
        <translation>Annuler reprendrait tout ce panneau.</translation>
    </message>
    <message>
        <source>Until isotropic</source>
        <translation>Jusqu'à l'isotropie</translation>
    </message>
    <message>
        <source>Until they meet</source>
        <translation>Jusqu'à la rencontre</translation>
    </message>
    <message>
        <source>Up to date</source>
        <translation>À jour</translation>
    </message>
    <message>
        <source>Update automatically</source>
        <translation>Mise à jour automatique</translation>
    </message>
    <message>
        <source>Use this height</source>
        <translation>Prendre cette hauteur</translation>
    </message>
    <message>
        <source>VTK legacy</source>
        <translation>VTK (ancien)</translation>
    </message>
    <message>
        <source>VTK unstructured grid</source>
        <translation>VTK, grille non structurée</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Viscosité</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Paroi</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Parois</translation>
    </message>
    <message>
        <source>Washers: rings about every hole</source>
        <translation>Rondelles : anneaux autour de chaque trou</translation>
    </message>
    <message>
        <source>Wavefront</source>
        <translation>Wavefront</translation>
    </message>
    <message>
        <source>What is checked</source>
        <translation>Ce qui est vérifié</translation>
    </message>
    <message>
        <source>What the colours of the elements in the 3D view stand for</source>
        <translation>Ce que signifient les couleurs des éléments dans la vue 3D</translation>
    </message>
    <message>
        <source>When the edges of the elements are drawn; near: where they are far enough apart</source>
        <translation>Quand les arêtes des éléments sont dessinées ; de près : là où elles sont assez écartées</translation>
    </message>
    <message>
        <source>Y plus</source>
        <translation>y+</translation>
    </message>
    <message>
        <source>a document object is needed to mesh, got {}</source>
        <translation>il faut un objet de document à mailler, et non {}</translation>
    </message>
    <message>
        <source>a face</source>
        <translation>une face</translation>
    </message>
    <message>
        <source>a face needs a size</source>
        <translation>une face a besoin d'une taille</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>un nombre fini</translation>
    </message>
    <message>
        <source>air</source>
        <translation>air</translation>
    </message>
    <message>
        <source>all faces</source>
        <translation>toutes les faces</translation>
    </message>
    <message>
        <source>all layers made</source>
        <translation>toutes les couches faites</translation>
    </message>
    <message>
        <source>all layers {} (orange)</source>
        <translation>toutes les couches {} (orange)</translation>
    </message>
    <message>
        <source>an edge</source>
        <translation>une arête</translation>
    </message>
    <message>
        <source>an entry needs a size, segments, cluster or a segment at an end</source>
        <translation>une entrée doit avoir une taille, des segments, un resserrement ou un segment à une extrémité</translation>
    </message>
    <message>
        <source>and {} exclude each other</source>
        <translation>et {} s'excluent</translation>
    </message>
    <message>
        <source>another front is too near</source>
        <translation>un autre front est trop proche</translation>
    </message>
    <message>
        <source>as high as wide</source>
        <translation>aussi haut que large</translation>
    </message>
    <message>
        <source>asks for some {} elements, {} MB and {} s; {} allows {}</source>
        <translation>demande environ {} éléments, {} Mo et {} s ; {} permet {}</translation>
    </message>
    <message>
        <source>both_ends needs a cluster</source>
        <translation>Deux bouts a besoin d'un resserrement</translation>
    </message>
    <message>
        <source>cannot be installed: {}</source>
        <translation>ne peut pas être installé : {}</translation>
    </message>
    <message>
        <source>cannot be kept: one is {} times as long as high, and {} is the most; split them, or raise first_height</source>
        <translation>ne peuvent pas être gardés : l'un est {} fois plus long que haut, et {} est le maximum ; coupez-les ou augmentez la première hauteur</translation>
    </message>
    <message>
        <source>cannot be overwritten: {}</source>
        <translation>ne peut pas être écrasé : {}</translation>
    </message>
    <message>
        <source>cannot be read: it does not end within {} s: {}</source>
        <translation>ne peut être lu : la lecture ne finit pas en {} s : {}</translation>
    </message>
    <message>
        <source>cannot be read: it takes more than {} MB: {}</source>
        <translation>ne peut être lu : il faut plus de {} Mo : {}</translation>
    </message>
    <message>
        <source>cannot be read: no process can be started for it: {}: {}</source>
        <translation>ne peut être lu : aucun processus ne peut être lancé pour cela : {} : {}</translation>
    </message>
    <message>
        <source>cannot be read: {}</source>
        <translation>ne peut pas être lu : {}</translation>
    </message>
    <message>
        <source>cannot be read: {}: {}</source>
        <translation>ne peut pas être lu : {} : {}</translation>
    </message>
    <message>
        <source>cannot be set to {}: {}</source>
        <translation>ne peut pas prendre la valeur {} : {}</translation>
    </message>
    <message>
        <source>cannot be used: {}: {}</source>
        <translation>n'est pas utilisable : {} : {}</translation>
    </message>
    <message>
        <source>cannot be written: {}</source>
        <translation>ne peut pas être écrit : {}</translation>
    </message>
    <message>
        <source>cannot read the job file: {}</source>
        <translation>le fichier de tâche ne peut pas être lu : {}</translation>
    </message>
    <message>
        <source>cfd</source>
        <translation>CFD</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>constante</translation>
    </message>
    <message>
        <source>cuts the mesh: it lies on both sides</source>
        <translation>coupe le maillage : il se trouve des deux côtés</translation>
    </message>
    <message>
        <source>does not exist: {}</source>
        <translation>n'existe pas : {}</translation>
    </message>
    <message>
        <source>does not go with axis_direction</source>
        <translation>ne va pas avec axis_direction</translation>
    </message>
    <message>
        <source>does not go with extrude</source>
        <translation>ne va pas avec extrude</translation>
    </message>
    <message>
        <source>element {number} {where}: angles from {least:.1f}° to {largest:.1f}°</source>
        <translation>élément {number} {where} : angles de {least:.1f}° à {largest:.1f}°</translation>
    </message>
    <message>
        <source>element {}: quality {:.2f}</source>
        <translation>élément {} : qualité {:.2f}</translation>
    </message>
    <message>
        <source>error</source>
        <translation>erreur</translation>
    </message>
    <message>
        <source>expands to {} MB: {}</source>
        <translation>se décompresse en {} Mo : {}</translation>
    </message>
    <message>
        <source>fem</source>
        <translation>EF</translation>
    </message>
    <message>
        <source>finds no edge for {}</source>
        <translation>ne trouve aucune arête pour {}</translation>
    </message>
    <message>
        <source>first height {} (blue)</source>
        <translation>première hauteur {} (bleu)</translation>
    </message>
    <message>
        <source>first height {} mm (Reynolds number {}); the boundary layer is some {} mm thick: {} layers of growth {}</source>
        <translation>première hauteur {} mm (nombre de Reynolds {}) ; la couche limite a une épaisseur d'environ {} mm : {} couches de croissance {}</translation>
    </message>
    <message>
        <source>for Python {} and version {} is not there: {}</source>
        <translation>pour Python {} et la version {} n’existe pas : {}</translation>
    </message>
    <message>
        <source>geometric</source>
        <translation>géométrique</translation>
    </message>
    <message>
        <source>give a model in which {} fails</source>
        <translation>donnent un modèle dans lequel {} échoue</translation>
    </message>
    <message>
        <source>goes with axis_direction only</source>
        <translation>ne va qu'avec axis_direction</translation>
    </message>
    <message>
        <source>goes with order 2 only, got 9</source>
        <translation>ne va qu'avec l'ordre 2, mais vaut 9</translation>
    </message>
    <message>
        <source>has a member outside of itself, {}: {}</source>
        <translation>a un élément en dehors de lui-même, {} : {}</translation>
    </message>
    <message>
        <source>has a name that is too long for its folder: {}</source>
        <translation>a un nom trop long pour son dossier : {}</translation>
    </message>
    <message>
        <source>has no surface elements: {}</source>
        <translation>n'a pas d'éléments de surface : {}</translation>
    </message>
    <message>
        <source>has the unknown format {} (known: {}): {}</source>
        <translation>est d'un format inconnu, {} (connus : {}) : {}</translation>
    </message>
    <message>
        <source>has the unknown format {} ({}): {}</source>
        <translation>est d'un format inconnu, {} ({}) : {}</translation>
    </message>
    <message>
        <source>holds a number too many: {}</source>
        <translation>contient un nombre de trop : {}</translation>
    </message>
    <message>
        <source>holds no face to mesh: {}</source>
        <translation>aucune face à mailler : {}</translation>
    </message>
    <message>
        <source>holds the name {}, which cannot be written</source>
        <translation>le nom {} ne peut pas être écrit</translation>
    </message>
    <message>
        <source>holds the name {}, which ends a part of an I-DEAS file</source>
        <translation>contient le nom {}, qui termine une partie d’un fichier I-DEAS</translation>
    </message>
    <message>
        <source>holds {}, which is no face, edge or vertex</source>
        <translation>{} n'est ni une face, ni une arête, ni un sommet</translation>
    </message>
    <message>
        <source>holds {}, which is no name like {}</source>
        <translation>{} n'est pas un nom comme {}</translation>
    </message>
    <message>
        <source>in layer {}</source>
        <translation>dans la couche {}</translation>
    </message>
    <message>
        <source>in layers</source>
        <translation>en couches</translation>
    </message>
    <message>
        <source>in the core</source>
        <translation>dans le cœur</translation>
    </message>
    <message>
        <source>in {}</source>
        <translation>en {}</translation>
    </message>
    <message>
        <source>is a folder: {}</source>
        <translation>est un dossier : {}</translation>
    </message>
    <message>
        <source>is a name that the mesh itself gives to a group</source>
        <translation>ce nom est donné par le maillage lui-même à un groupe</translation>
    </message>
    <message>
        <source>is damaged, or no FreeCAD document: {}: {}</source>
        <translation>est endommagé ou n’est pas un document FreeCAD : {} : {}</translation>
    </message>
    <message>
        <source>is damaged: it has too many members, or one twice: {}</source>
        <translation>est endommagé : il a trop d’éléments, ou un en double : {}</translation>
    </message>
    <message>
        <source>is damaged: its reader crashes on it ({}): {}</source>
        <translation>est endommagé : son lecteur plante ({}) : {}</translation>
    </message>
    <message>
        <source>is exceeded in {}: {} % of the tetrahedra have an angle below {} degrees between their sides, beside elements that are thin: raise first_height there, or lower size</source>
        <translation>est dépassé dans {} : {} % des tétraèdres ont un angle inférieur à {} degrés entre leurs faces, près des éléments minces : augmentez-y la première hauteur ou réduisez la taille</translation>
    </message>
    <message>
        <source>is for FCStd files only, got {}</source>
        <translation>pour les fichiers FCStd seulement, donné : {}</translation>
    </message>
    <message>
        <source>is given twice</source>
        <translation>est donné deux fois</translation>
    </message>
    <message>
        <source>is larger than any of the core: {}</source>
        <translation>est plus grand que tout fichier du noyau : {}</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>manque</translation>
    </message>
    <message>
        <source>is neither cell, constraint nor property of {}</source>
        <translation>n’est ni cellule, ni contrainte, ni propriété de {}</translation>
    </message>
    <message>
        <source>is neither file nor folder: {}</source>
        <translation>n’est ni fichier ni dossier : {}</translation>
    </message>
    <message>
        <source>is no FreeCAD document: it lacks {}: {}</source>
        <translation>n’est pas un document FreeCAD : {} manque : {}</translation>
    </message>
    <message>
        <source>is no file: {}</source>
        <translation>n'est pas un fichier : {}</translation>
    </message>
    <message>
        <source>is no known key</source>
        <translation>n'est pas une clé connue</translation>
    </message>
    <message>
        <source>is no known key (did you mean {}?)</source>
        <translation>n'est pas une clé connue (vouliez-vous dire {} ?)</translation>
    </message>
    <message>
        <source>is no name like {}</source>
        <translation>n’est pas un nom comme {}</translation>
    </message>
    <message>
        <source>is no regular file: {}</source>
        <translation>n’est pas un fichier ordinaire : {}</translation>
    </message>
    <message>
        <source>is not installed: {}</source>
        <translation>n'est pas installé : {}</translation>
    </message>
    <message>
        <source>is of surfaces: 9 does not go with extrude or volume</source>
        <translation>concerne les surfaces : 9 ne va pas avec l'extrusion ni le volume</translation>
    </message>
    <message>
        <source>is the name of the front, too: {}</source>
        <translation>porte le nom de l'avant : {}</translation>
    </message>
    <message>
        <source>it bounds no face</source>
        <translation>elle ne borde aucune face</translation>
    </message>
    <message>
        <source>it bounds {} alone</source>
        <translation>elle ne borde que {}</translation>
    </message>
    <message>
        <source>it has no area</source>
        <translation>elle n'a pas d'aire</translation>
    </message>
    <message>
        <source>it has no boundary wire</source>
        <translation>elle n'a pas de contour</translation>
    </message>
    <message>
        <source>it has no element about {} on {}: it is a mesh of another shape, or not whole</source>
        <translation>il n'a pas d'élément près de {} sur {} : c'est le maillage d'une autre forme, ou il est incomplet</translation>
    </message>
    <message>
        <source>it has no finite bounds</source>
        <translation>elle n'est pas bornée</translation>
    </message>
    <message>
        <source>it has no surface</source>
        <translation>elle n'a pas de surface</translation>
    </message>
    <message>
        <source>it has no surface elements</source>
        <translation>il n'a pas d'éléments de surface</translation>
    </message>
    <message>
        <source>it is a pole without length</source>
        <translation>c'est un pôle sans longueur</translation>
    </message>
    <message>
        <source>it is cut off: it lacks the line {}</source>
        <translation>il est tronqué : la ligne {} manque</translation>
    </message>
    <message>
        <source>it is cut off: its last line is missing</source>
        <translation>il est tronqué : la dernière ligne manque</translation>
    </message>
    <message>
        <source>it is damaged: #{} ({}) cannot be read: {}</source>
        <translation>il est endommagé : #{} ({}) ne peut être lu : {}</translation>
    </message>
    <message>
        <source>it is damaged: #{} ({}) is part of nothing</source>
        <translation>il est endommagé : #{} ({}) n’appartient à rien</translation>
    </message>
    <message>
        <source>it is damaged: #{} ({}) refers to #{}, which is not there</source>
        <translation>il est endommagé : #{} ({}) renvoie à #{}, qui n’existe pas</translation>
    </message>
    <message>
        <source>it is damaged: #{} is given twice</source>
        <translation>il est endommagé : #{} y figure deux fois</translation>
    </message>
    <message>
        <source>it is damaged: an entry has lost a line</source>
        <translation>il est endommagé : une entrée a perdu une ligne</translation>
    </message>
    <message>
        <source>it is damaged: it holds no entity</source>
        <translation>il est endommagé : il ne contient aucune entité</translation>
    </message>
    <message>
        <source>it is damaged: line {}: {}</source>
        <translation>il est endommagé : ligne {} : {}</translation>
    </message>
    <message>
        <source>it is damaged: line {}: {} is missing</source>
        <translation>il est endommagé : ligne {} : {} manque</translation>
    </message>
    <message>
        <source>it is damaged: of the lines {} it has {}, its last line says {}</source>
        <translation>il est endommagé : il a, des lignes {}, {}, sa dernière ligne en annonce {}</translation>
    </message>
    <message>
        <source>it is damaged: the entry D{} has no parameters of its type {}</source>
        <translation>il est endommagé : l’entrée D{} n’a pas de paramètres de son type {}</translation>
    </message>
    <message>
        <source>it is damaged: the entry D{} has no type</source>
        <translation>il est endommagé : l’entrée D{} n’a pas de type</translation>
    </message>
    <message>
        <source>it is damaged: the face #{} or a bound of it could not be made</source>
        <translation>il est endommagé : la face #{} ou un de ses bords n’a pu être construit</translation>
    </message>
    <message>
        <source>it is damaged: the face D{} or a bound of it could not be made</source>
        <translation>il est endommagé : la face D{} ou un de ses bords n’a pu être construit</translation>
    </message>
    <message>
        <source>it is damaged: triangle {} has a corner that is nowhere</source>
        <translation>il est endommagé : le triangle {} a un coin qui n’est nulle part</translation>
    </message>
    <message>
        <source>it is damaged: {} has no end</source>
        <translation>il est endommagé : {} n’a pas de fin</translation>
    </message>
    <message>
        <source>it is damaged: {} lies {} mm off {}</source>
        <translation>il est endommagé : {} est à {} mm de {}</translation>
    </message>
    <message>
        <source>it is damaged: {} triangles take {} bytes, it has {}</source>
        <translation>il est endommagé : {} triangles prennent {} octets, il en a {}</translation>
    </message>
    <message>
        <source>it is no IGES file: its first line is missing</source>
        <translation>ce n’est pas un fichier IGES : la première ligne manque</translation>
    </message>
    <message>
        <source>it is no STEP file: it lacks the line {}</source>
        <translation>ce n’est pas un fichier STEP : la ligne {} manque</translation>
    </message>
    <message>
        <source>it is no STL file</source>
        <translation>ce n’est pas un fichier STL</translation>
    </message>
    <message>
        <source>it is not allowed to write there</source>
        <translation>l'écriture n'y est pas permise</translation>
    </message>
    <message>
        <source>its boundary is open after {}</source>
        <translation>son contour est ouvert après {}</translation>
    </message>
    <message>
        <source>its boundary runs around the closed surface without a seam, at {}</source>
        <translation>son contour fait le tour de la surface fermée sans couture, à {}</translation>
    </message>
    <message>
        <source>its faces meet at {} degrees, and {} is the most that layers run over</source>
        <translation>ses faces se rencontrent à {} degrés ; les couches en franchissent {} au plus</translation>
    </message>
    <message>
        <source>its faces use it more than twice</source>
        <translation>ses faces l'emploient plus de deux fois</translation>
    </message>
    <message>
        <source>its whole boundary is shorter than its tolerance</source>
        <translation>tout son bord est plus court que sa tolérance</translation>
    </message>
    <message>
        <source>joined with its neighbour</source>
        <translation>fusionné avec son voisin</translation>
    </message>
    <message>
        <source>layers 0 grows until the fronts close, which leaves no choice of thickness</source>
        <translation>0 couche veut dire : jusqu'à la fermeture des fronts ; l'épaisseur ne peut alors être choisie</translation>
    </message>
    <message>
        <source>lies in a folder that cannot be written to: {}</source>
        <translation>on ne peut rien écrire dans ce dossier : {}</translation>
    </message>
    <message>
        <source>lies in a folder that does not exist: {}</source>
        <translation>ce dossier n'existe pas : {}</translation>
    </message>
    <message>
        <source>match</source>
        <translation>raccord</translation>
    </message>
    <message>
        <source>meshed on their own, as the elements of their patches could not follow them: {}</source>
        <translation>Maillées à part, car les éléments de leurs parties ne pouvaient pas les suivre : {}</translation>
    </message>
    <message>
        <source>meshed on their own, as their patches could not be meshed with them: {}</source>
        <translation>maillées seules, car leurs domaines ne pouvaient l'être avec elles : {}</translation>
    </message>
    <message>
        <source>meshed on their own, as they are curved more tightly than layers of this size can follow: {}</source>
        <translation>Maillées à part, car leur courbure est trop forte pour des couches de cette taille : {}</translation>
    </message>
    <message>
        <source>must be "all" or a list of walls, got {}</source>
        <translation>attendu "all" ou une liste de parois, donné {}</translation>
    </message>
    <message>
        <source>must be "split" at order 2, got "keep"</source>
        <translation>doit valoir "split" à l'ordre 2, pas "keep"</translation>
    </message>
    <message>
        <source>must be a file of its own that ends in {}, got {}</source>
        <translation>doit être un fichier à part qui finit par {}, mais c’est {}</translation>
    </message>
    <message>
        <source>must be a finite number, got {}</source>
        <translation>attendu un nombre fini, donné {}</translation>
    </message>
    <message>
        <source>must be a list of files, got {}</source>
        <translation>attendu une liste de fichiers, donné {}</translation>
    </message>
    <message>
        <source>must be a list of names like {}, got {}</source>
        <translation>attendu une liste de noms comme {}, donné {}</translation>
    </message>
    <message>
        <source>must be a list, got {}</source>
        <translation>attendu une liste, donné {}</translation>
    </message>
    <message>
        <source>must be a mesh object, got {}</source>
        <translation>attendu un objet maillage, donné {}</translation>
    </message>
    <message>
        <source>must be a number or a text, got {}</source>
        <translation>doit être un nombre ou un texte, mais c’est {}</translation>
    </message>
    <message>
        <source>must be a number {}, got {}</source>
        <translation>attendu un nombre {}, donné {}</translation>
    </message>
    <message>
        <source>must be a number, got {}</source>
        <translation>attendu un nombre, donné {}</translation>
    </message>
    <message>
        <source>must be a text, got {}</source>
        <translation>attendu un texte, donné {}</translation>
    </message>
    <message>
        <source>must be a whole number or "isotropic", got {}</source>
        <translation>attendu un nombre entier ou "isotropic", donné {}</translation>
    </message>
    <message>
        <source>must be a whole number, got {}</source>
        <translation>attendu un nombre entier, donné {}</translation>
    </message>
    <message>
        <source>must be an object of names and lists, got {}</source>
        <translation>attendu un objet de noms et de listes, donné {}</translation>
    </message>
    <message>
        <source>must be an object of names and values, got {}</source>
        <translation>doit être un objet de noms et de valeurs, mais c’est {}</translation>
    </message>
    <message>
        <source>must be an object of names and words, got {}</source>
        <translation>doit être un objet de noms et de mots, reçu {}</translation>
    </message>
    <message>
        <source>must be an object, got {}</source>
        <translation>attendu un objet, donné {}</translation>
    </message>
    <message>
        <source>must be at most 1000000, got {}</source>
        <translation>au plus 1000000, donné {}</translation>
    </message>
    <message>
        <source>must be at right angles to the plane, whose normal is ({}, {}, {})</source>
        <translation>doit être perpendiculaire au plan, dont la normale est ({}, {}, {})</translation>
    </message>
    <message>
        <source>must be in the same document as the shape, got {}</source>
        <translation>doit être dans le même document que la forme, donné {}</translation>
    </message>
    <message>
        <source>must be one of {}, got {}</source>
        <translation>attendu l'un de {}, donné {}</translation>
    </message>
    <message>
        <source>must be three numbers, got {}</source>
        <translation>attendu trois nombres, donné {}</translation>
    </message>
    <message>
        <source>must be true or false, got {}</source>
        <translation>attendu vrai ou faux, donné {}</translation>
    </message>
    <message>
        <source>must be {}, got {}</source>
        <translation>attendu {}, donné {}</translation>
    </message>
    <message>
        <source>must have a length</source>
        <translation>doit avoir une longueur</translation>
    </message>
    <message>
        <source>must hold texts like "Face1 move x y z", got {}</source>
        <translation>doit contenir des textes comme « Face1 move x y z », pas {}</translation>
    </message>
    <message>
        <source>must hold texts like "x y z size radius", got {}</source>
        <translation>attendu des textes comme « x y z taille rayon », donné {}</translation>
    </message>
    <message>
        <source>must lie in the plane of the mesh</source>
        <translation>doit se trouver dans le plan du maillage</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>ne doit pas être vide</translation>
    </message>
    <message>
        <source>names all of {}: pick its faces or edges</source>
        <translation>{} est nommé en entier : choisissez-en des faces ou des arêtes</translation>
    </message>
    <message>
        <source>names no file, and there is no report: nothing to do</source>
        <translation>aucun fichier nommé, ni rapport : rien à faire</translation>
    </message>
    <message>
        <source>names no object of the document, or several</source>
        <translation>ne nomme aucun objet du document, ou plusieurs</translation>
    </message>
    <message>
        <source>names {} of {}, which is no part of {}</source>
        <translation>{} de {} est nommé, qui n'est pas une partie de {}</translation>
    </message>
    <message>
        <source>names {} twice</source>
        <translation>{} est nommé deux fois</translation>
    </message>
    <message>
        <source>names {}, but the shape has {} of that kind</source>
        <translation>{} est nommé, mais la forme n'en a que {}</translation>
    </message>
    <message>
        <source>names {}, but {} has {} edges</source>
        <translation>{} est nommé, mais {} a {} arêtes</translation>
    </message>
    <message>
        <source>names {}, but {} has {} faces</source>
        <translation>{} est nommé, mais {} a {} faces</translation>
    </message>
    <message>
        <source>names {}, which is not in faces</source>
        <translation>{} est nommé, mais n'est pas parmi les faces à mailler</translation>
    </message>
    <message>
        <source>narrower than a tenth of the size, and their elements with them: {}</source>
        <translation>Plus étroites que le dixième de la taille, et leurs éléments avec elles : {}</translation>
    </message>
    <message>
        <source>narrower than a tenth of the size, and their elements with them: {} and {} more</source>
        <translation>Plus étroites que le dixième de la taille, et leurs éléments avec elles : {} et {} autres</translation>
    </message>
    <message>
        <source>needs FreeCAD to be read: run the job with freecadcmd: {}</source>
        <translation>a besoin de FreeCAD pour être lu : lancez la tâche avec freecadcmd : {}</translation>
    </message>
    <message>
        <source>needs FreeCAD to be written: run the job with freecadcmd: {}</source>
        <translation>a besoin de FreeCAD pour être écrit : lancez la tâche avec freecadcmd : {}</translation>
    </message>
    <message>
        <source>needs a mesh of plane faces: there is no element</source>
        <translation>a besoin d'un maillage de faces planes : aucun élément</translation>
    </message>
    <message>
        <source>needs both density and viscosity, or none of them</source>
        <translation>demande la masse volumique et la viscosité, ou aucune des deux</translation>
    </message>
    <message>
        <source>needs plane faces: a node lies {} mm off their plane</source>
        <translation>a besoin de faces planes : un nœud est à {} mm de leur plan</translation>
    </message>
    <message>
        <source>needs the Python package meshio (python3-meshio): {}</source>
        <translation>a besoin du paquet Python meshio (python3-meshio) : {}</translation>
    </message>
    <message>
        <source>needs the Python package {} (python3-{}): {}</source>
        <translation>nécessite le paquet Python {} (python3-{}) : {}</translation>
    </message>
    <message>
        <source>no growth from 1 to {} makes {} layers from {} mm {} mm thick</source>
        <translation>aucune croissance de 1 à {} ne donne à {} couches partant de {} mm une épaisseur de {} mm</translation>
    </message>
    <message>
        <source>no shape could be read, it is no {} file or holds none</source>
        <translation>aucune forme n’a pu être lue, ce n’est pas un fichier {} ou il n’en contient pas</translation>
    </message>
    <message>
        <source>no tetrahedron came out, exit status {}</source>
        <translation>aucun tétraèdre n'en est sorti, code de retour {}</translation>
    </message>
    <message>
        <source>no valid element fits</source>
        <translation>aucun élément valide ne convient</translation>
    </message>
    <message>
        <source>node {} (from 0) at {} lies {} mm off the shape; the most is {} mm, a quarter of the mesh's edge length there</source>
        <translation>le nœud {} (compté à partir de 0) en {} est à {} mm de la forme ; {} mm au plus sont permis, le quart de la longueur d'arête du maillage à cet endroit</translation>
    </message>
    <message>
        <source>node {} (from 0) has the coordinates {}</source>
        <translation>le nœud {} (compté à partir de 0) a les coordonnées {}</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>note</source>
        <translation>remarque</translation>
    </message>
    <message>
        <source>nothing arrived there: the disk may be full</source>
        <translation>rien n'y est arrivé : le disque est peut-être plein</translation>
    </message>
    <message>
        <source>of a new {} must not be empty</source>
        <translation>rien n'est choisi pour le nouvel objet ({})</translation>
    </message>
    <message>
        <source>of a {} cannot hold {}</source>
        <translation>impossible pour un tel objet ({}) : {}</translation>
    </message>
    <message>
        <source>off</source>
        <translation>sans effet</translation>
    </message>
    <message>
        <source>pick a face or an edge of {}</source>
        <translation>choisissez une face ou une arête de {}</translation>
    </message>
    <message>
        <source>pick a face, an edge or a vertex of {}</source>
        <translation>choisissez une face, une arête ou un sommet de {}</translation>
    </message>
    <message>
        <source>pipe</source>
        <translation>conduite</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>plaque</translation>
    </message>
    <message>
        <source>point {} of a triangulation is not finite</source>
        <translation>le point {} d'une triangulation n'est pas fini</translation>
    </message>
    <message>
        <source>polyMesh: three cells share a face</source>
        <translation>polyMesh : trois cellules partagent une face</translation>
    </message>
    <message>
        <source>quads</source>
        <translation>quadrangles</translation>
    </message>
    <message>
        <source>result() was called already; keep what it gave</source>
        <translation>result() a déjà été appelé ; gardez ce qu'il a donné</translation>
    </message>
    <message>
        <source>segments and cluster are of edges, and the entry lists none</source>
        <translation>segments et resserrement valent pour des arêtes, et aucune n'est choisie</translation>
    </message>
    <message>
        <source>select faces or edges in the 3D view first</source>
        <translation>sélectionnez d'abord des faces ou des arêtes dans la vue 3D</translation>
    </message>
    <message>
        <source>select in the 3D view first: {}</source>
        <translation>sélectionnez d'abord dans la vue 3D : {}</translation>
    </message>
    <message>
        <source>select {} first</source>
        <translation>sélectionnez d'abord {}</translation>
    </message>
    <message>
        <source>sewing joined {} edges; free edges left: {}</source>
        <translation>La couture a joint {} arêtes ; arêtes libres restantes : {}</translation>
    </message>
    <message>
        <source>sewing left nothing of the shape</source>
        <translation>la couture n'a rien laissé de la forme</translation>
    </message>
    <message>
        <source>shorter than a tenth of the size, and the mesh edges with them: {}</source>
        <translation>Plus courtes que le dixième de la taille, et les arêtes du maillage avec elles : {}</translation>
    </message>
    <message>
        <source>shorter than a tenth of the size, and the mesh edges with them: {} and {} more</source>
        <translation>Plus courtes que le dixième de la taille, et les arêtes du maillage avec elles : {} et {} autres</translation>
    </message>
    <message>
        <source>shorter than the tolerance about them, and one point in the mesh: {}</source>
        <translation>Plus courtes que la tolérance autour d'elles, et un point dans le maillage : {}</translation>
    </message>
    <message>
        <source>shorter than the tolerance about them, and one point in the mesh: {} and {} more</source>
        <translation>Plus courtes que la tolérance autour d'elles, et un point dans le maillage : {} et {} autres</translation>
    </message>
    <message>
        <source>size and segments of an edge exclude each other</source>
        <translation>taille et nombre de segments d'une arête s'excluent</translation>
    </message>
    <message>
        <source>tanh</source>
        <translation>tanh</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>le disque est plein</translation>
    </message>
    <message>
        <source>the folder does not exist</source>
        <translation>le dossier n'existe pas</translation>
    </message>
    <message>
        <source>the fronts have met</source>
        <translation>les fronts se sont rencontrés</translation>
    </message>
    <message>
        <source>the job file is nested too deeply</source>
        <translation>le fichier de tâche est trop imbriqué</translation>
    </message>
    <message>
        <source>the job file is no JSON: {} in line {}</source>
        <translation>le fichier de tâche n'est pas du JSON : {} à la ligne {}</translation>
    </message>
    <message>
        <source>the job file is not UTF-8 text</source>
        <translation>le fichier de tâche n'est pas du texte UTF-8</translation>
    </message>
    <message>
        <source>the job file must hold one JSON object</source>
        <translation>le fichier de tâche doit contenir un objet JSON</translation>
    </message>
    <message>
        <source>the layers beside have ended</source>
        <translation>les couches voisines se sont arrêtées</translation>
    </message>
    <message>
        <source>the mesh will have some {} elements</source>
        <translation>le maillage aura environ {} éléments</translation>
    </message>
    <message>
        <source>the meshing core is not built for this FreeCAD (Python {}): run "./dev build" in {} and start FreeCAD again ({})</source>
        <translation>Le noyau de maillage n'est pas construit pour ce FreeCAD (Python {}) : lancez "./dev build" dans {} et redémarrez FreeCAD ({})</translation>
    </message>
    <message>
        <source>the meshing core is of version {}, but this add-on needs {}: install the core of the same version ({})</source>
        <translation>le noyau de maillage a la version {}, mais cette extension demande {} : installez le noyau de la même version ({})</translation>
    </message>
    <message>
        <source>the model has changed under the references: {}. Pick them again, or use Follow References or Accept References</source>
        <translation>Le modèle a changé sous les références : {}. Choisissez-les à nouveau, ou utilisez « Suivre les références » ou « Accepter les références »</translation>
    </message>
    <message>
        <source>the shape holds no face</source>
        <translation>la forme n'a pas de face</translation>
    </message>
    <message>
        <source>the surface bends too sharply</source>
        <translation>la surface se courbe trop fort</translation>
    </message>
    <message>
        <source>the text is no BREP shape</source>
        <translation>le texte n'est pas une forme BREP</translation>
    </message>
    <message>
        <source>the text is no BREP shape: it lacks the line {}</source>
        <translation>le texte n'est pas une forme BREP : il lui manque la ligne {}</translation>
    </message>
    <message>
        <source>the text is no BREP shape: line {}: {}</source>
        <translation>le texte n'est pas une forme BREP : ligne {} : {}</translation>
    </message>
    <message>
        <source>the triangulation took {} of the {} nodes of the initial mesh; the others lie on edges or too near to their neighbours</source>
        <translation>La triangulation a repris {} des {} nœuds du maillage initial ; les autres sont sur des arêtes ou trop près de leurs voisins</translation>
    </message>
    <message>
        <source>there is no snapshot after result(): it gave the mesh</source>
        <translation>il n'y a plus d'instantané après result() : il a donné le maillage</translation>
    </message>
    <message>
        <source>thickness needs a first height that is the same along the wall</source>
        <translation>l'épaisseur demande une première hauteur constante le long de la paroi</translation>
    </message>
    <message>
        <source>thickness would take {} layers</source>
        <translation>l'épaisseur demanderait {} couches</translation>
    </message>
    <message>
        <source>thickness {} mm is less than the first height {} mm</source>
        <translation>l'épaisseur {} mm est inférieure à la première hauteur {} mm</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>triangle {} (from 0) has node {}, but there are {}</source>
        <translation>le triangle {} (compté à partir de 0) a le nœud {}, mais il n'y en a que {}</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>triangles</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>paroi</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>avertissement</translation>
    </message>
    <message>
        <source>washers</source>
        <translation>rondelles</translation>
    </message>
    <message>
        <source>water</source>
        <translation>eau</translation>
    </message>
    <message>
        <source>without a unit</source>
        <translation>sans unité</translation>
    </message>
    <message>
        <source>would overwrite {}: {}</source>
        <translation>écraserait {} : {}</translation>
    </message>
    <message>
        <source>{edge} on {face} has no layer</source>
        <translation>{edge} sur {face} n'a pas de couche</translation>
    </message>
    <message>
        <source>{edge} on {face}: layers end here first: {reason}</source>
        <translation>{edge} sur {face} : les couches finissent ici d'abord : {reason}</translation>
    </message>
    <message>
        <source>{edge} on {face}: the first height is most off here, by {error:+.1f} %</source>
        <translation>{edge} sur {face} : la première hauteur s'écarte ici le plus, de {error:+.1f} %</translation>
    </message>
    <message>
        <source>{label}: layer {layer}, {elements} elements, {seconds} s</source>
        <translation>{label} : couche {layer}, {elements} éléments, {seconds} s</translation>
    </message>
    <message>
        <source>{label}: {quads} quads, {triangles} triangles, {percent:.1f} % quads, {good:.1f} % of angles in 45–135°, angles from {least:.1f}° to {largest:.1f}°</source>
        <translation>{label} : {quads} quadrangles, {triangles} triangles, {percent:.1f} % de quadrangles, {good:.1f} % des angles dans 45–135°, angles de {least:.1f}° à {largest:.1f}°</translation>
    </message>
    <message>
        <source>{label}: {seconds} s</source>
        <translation>{label} : {seconds} s</translation>
    </message>
    <message>
        <source>{quads} quads and {triangles} triangles ({percent:.1f} % quads) in {seconds:.1f} s</source>
        <translation>{quads} quadrangles et {triangles} triangles ({percent:.1f} % de quadrangles) en {seconds:.1f} s</translation>
    </message>
    <message>
        <source>{stage} · {elements} elements · {percent:.1f} % quads · {seconds:.1f} s</source>
        <translation>{stage} · {elements} éléments · {percent:.1f} % de quadrangles · {seconds:.1f} s</translation>
    </message>
    <message>
        <source>{stage} · {seconds:.1f} s</source>
        <translation>{stage} · {seconds:.1f} s</translation>
    </message>
    <message>
        <source>{} (internal error: please report it with the model)</source>
        <translation>{} (erreur interne : signalez-la avec le modèle)</translation>
    </message>
    <message>
        <source>{} and {}</source>
        <translation>{} et {}</translation>
    </message>
    <message>
        <source>{} and {} exclude each other</source>
        <translation>{} et {} s'excluent</translation>
    </message>
    <message>
        <source>{} and {} more: first heights from {} to {} mm, off those asked for ({} mm on average) by up to {} %</source>
        <translation>{} et {} autres : premières hauteurs de {} à {} mm ; demandé : {} mm en moyenne, écart jusqu'à {} %</translation>
    </message>
    <message>
        <source>{} belongs to no layer mesh of a shape</source>
        <translation>{} n'appartient à aucun maillage en couches d'une forme</translation>
    </message>
    <message>
        <source>{} bounds no meshed patch, and no layers grow from it; listed in boundary, it bounds its faces</source>
        <translation>{} ne borde aucune partie maillée, et aucune couche n'en part ; déclarée comme bord, elle borde ses faces</translation>
    </message>
    <message>
        <source>{} came after the mesh and does not act on it: update the mesh.</source>
        <translation>{} est venu après le maillage et n'agit pas sur lui : mettez le maillage à jour.</translation>
    </message>
    <message>
        <source>{} cannot be filled: {} of {} cells have no volume, or a negative one</source>
        <translation>{} ne peut pas être rempli : {} cellules sur {} ont un volume nul ou négatif</translation>
    </message>
    <message>
        <source>{} cannot be meshed: {}</source>
        <translation>{} ne peut pas être maillée : {}</translation>
    </message>
    <message>
        <source>{} cannot be written: {}</source>
        <translation>{} ne peut pas être écrit : {}</translation>
    </message>
    <message>
        <source>{} does not close to a manifold mesh</source>
        <translation>{} ne se ferme pas en un maillage de variété</translation>
    </message>
    <message>
        <source>{} elements are turned over.</source>
        <translation>{} éléments sont inversés.</translation>
    </message>
    <message>
        <source>{} elements of quality {:.2f} to {:.2f}</source>
        <translation>{} éléments de qualité {:.2f} à {:.2f}</translation>
    </message>
    <message>
        <source>{} faces meet there</source>
        <translation>{} faces s'y rencontrent</translation>
    </message>
    <message>
        <source>{} files have no edges: the group {} of {} would be lost in {}</source>
        <translation>les fichiers {} n’ont pas d’arêtes : le groupe {} de {} serait perdu dans {}</translation>
    </message>
    <message>
        <source>{} files have no elements of second order: {}</source>
        <translation>les fichiers {} n’ont pas d’éléments du second ordre : {}</translation>
    </message>
    <message>
        <source>{} files have no pyramids, which stand on quads that are kept: {}</source>
        <translation>Les fichiers {} n'ont pas de pyramides, qui se dressent sur les quadrangles gardés : {}</translation>
    </message>
    <message>
        <source>{} files have no pyramids, which the mesh has along the axis: {}</source>
        <translation>Les fichiers {} n'ont pas de pyramides, que le maillage a le long de l'axe : {}</translation>
    </message>
    <message>
        <source>{} files have no quads of {} nodes: {}</source>
        <translation>Les fichiers {} n'ont pas de quadrangles à {} nœuds : {}</translation>
    </message>
    <message>
        <source>{} files have no volume elements: {}</source>
        <translation>les fichiers {} n’ont pas d’éléments de volume : {}</translation>
    </message>
    <message>
        <source>{} files have one name for each element: {} is in the groups {} and {}, which {} cannot hold</source>
        <translation>les fichiers {} ont un seul nom par élément : {} est dans les groupes {} et {}, que {} ne peut contenir</translation>
    </message>
    <message>
        <source>{} has a slit there</source>
        <translation>{} y a une fente</translation>
    </message>
    <message>
        <source>{} has no (u, v) on {}</source>
        <translation>{} n'a pas de (u, v) sur {}</translation>
    </message>
    <message>
        <source>{} has no boundary edge that layers could grow from</source>
        <translation>{} n'a pas d'arête de bord d'où des couches pourraient partir</translation>
    </message>
    <message>
        <source>{} has no curve</source>
        <translation>{} n'a pas de courbe</translation>
    </message>
    <message>
        <source>{} has no curve in the face's (u, v)</source>
        <translation>{} n'a pas de courbe dans le (u, v) de la face</translation>
    </message>
    <message>
        <source>{} has no face to mesh</source>
        <translation>{} n'a pas de face à mailler</translation>
    </message>
    <message>
        <source>{} has no face to mesh: {}</source>
        <translation>{} n'a pas de face à mailler : {}</translation>
    </message>
    <message>
        <source>{} has no mesh yet: mesh it first</source>
        <translation>{} n'a pas encore de maillage : maillez-le d'abord</translation>
    </message>
    <message>
        <source>{} has no object to mesh</source>
        <translation>{} n'a pas d'objet à mailler</translation>
    </message>
    <message>
        <source>{} has no surface elements: mesh it first</source>
        <translation>{} n'a pas d'éléments de surface : maillez-le d'abord</translation>
    </message>
    <message>
        <source>{} has no value for its size: give one for the surroundings of {}</source>
        <translation>{} n'a pas de valeur pour la taille : donnez-en une pour les environs de {}</translation>
    </message>
    <message>
        <source>{} has none of these</source>
        <translation>{} n'en a aucun</translation>
    </message>
    <message>
        <source>{} has the sizes of {}, {} walls, {} local sizes and {} groups.</source>
        <translation>{} a les tailles de {}, {} parois, {} tailles locales et {} groupes.</translation>
    </message>
    <message>
        <source>{} has {} cells inside {}.</source>
        <translation>{} a {} cellules dans {}.</translation>
    </message>
    <message>
        <source>{} is called {} now</source>
        <translation>{} s'appelle maintenant {}</translation>
    </message>
    <message>
        <source>{} is damaged: {}</source>
        <translation>{} est endommagé : {}</translation>
    </message>
    <message>
        <source>{} is damaged: {} is not as its list says</source>
        <translation>{} est endommagé : {} n’est pas comme le dit sa liste</translation>
    </message>
    <message>
        <source>{} is gone from the model</source>
        <translation>{} a disparu du modèle</translation>
    </message>
    <message>
        <source>{} is in both {} and {}</source>
        <translation>{} est à la fois dans {} et dans {}</translation>
    </message>
    <message>
        <source>{} is in error, and its shape may be an older one: mend it first</source>
        <translation>{} est en erreur, et sa forme est peut-être ancienne : à réparer d'abord</translation>
    </message>
    <message>
        <source>{} is in error: the mesh cannot be updated before it is mended.</source>
        <translation>{} est en erreur : le maillage ne peut être mis à jour avant sa réparation.</translation>
    </message>
    <message>
        <source>{} is narrower than the tolerance of its edges: it holds no element, and its neighbours meet there</source>
        <translation>{} est plus étroite que la tolérance de ses arêtes : elle ne porte aucun élément, et ses voisines s'y rejoignent</translation>
    </message>
    <message>
        <source>{} is neither name nor label of an object: {}</source>
        <translation>{} n'est ni le nom ni l'étiquette d'un objet : {}</translation>
    </message>
    <message>
        <source>{} is no mesh made with Gmsh</source>
        <translation>{} n'est pas un maillage fait avec Gmsh</translation>
    </message>
    <message>
        <source>{} is no part of {}, which is meshed</source>
        <translation>{} n'est pas une partie de {}, qui est maillé</translation>
    </message>
    <message>
        <source>{} is not among the faces to mesh</source>
        <translation>{} n'est pas parmi les faces à mailler</translation>
    </message>
    <message>
        <source>{} is not closed: {} sides of elements have no neighbour, one at ({}, {}, {})</source>
        <translation>{} n'est pas fermé : {} côtés d'éléments n'ont pas de voisin, l'un en ({}, {}, {})</translation>
    </message>
    <message>
        <source>{} is not mapped: its outline has no four corners, and it is no ring in a plane</source>
        <translation>{} n'est pas réglée : son contour n'a pas quatre coins, et ce n'est pas un anneau plan</translation>
    </message>
    <message>
        <source>{} is not mapped: its sides are cut into different numbers of segments, or rows between them would fold</source>
        <translation>{} n'est pas réglée : ses côtés sont découpés en nombres différents de segments, ou des rangées entre eux se plieraient</translation>
    </message>
    <message>
        <source>{} is not meshed as {} is: they do not lie alike, or are parts of larger patches</source>
        <translation>{} n'est pas maillée comme {} : elles ne sont pas disposées de même, ou font partie de zones plus grandes</translation>
    </message>
    <message>
        <source>{} is not meshed: {}</source>
        <translation>{} n'est pas maillée : {}</translation>
    </message>
    <message>
        <source>{} is not there any more</source>
        <translation>{} n'existe plus</translation>
    </message>
    <message>
        <source>{} is not what its sum says: {} instead of {}</source>
        <translation>{} n’est pas ce que dit sa somme : {} au lieu de {}</translation>
    </message>
    <message>
        <source>{} is not what was picked</source>
        <translation>{} n'est pas ce qui avait été choisi</translation>
    </message>
    <message>
        <source>{} is on the list already</source>
        <translation>{} est déjà sur la liste</translation>
    </message>
    <message>
        <source>{} is the label of several objects: {}</source>
        <translation>{} est l'étiquette de plusieurs objets : {}</translation>
    </message>
    <message>
        <source>{} is too small: it would cut {} into {} segments</source>
        <translation>{} trop petite : {} serait coupée en {} segments</translation>
    </message>
    <message>
        <source>{} is too small: {} mm asks for {} elements, and {} are the most</source>
        <translation>{} trop petite : {} mm demandent {} éléments, {} sont le maximum</translation>
    </message>
    <message>
        <source>{} joins no two sides of {}</source>
        <translation>{} ne joint pas deux côtés de {}</translation>
    </message>
    <message>
        <source>{} layers</source>
        <translation>{} couches</translation>
    </message>
    <message>
        <source>{} meets the wall {} at {} degrees on {}: layers end there instead of running along it</source>
        <translation>{} rencontre la paroi {} à {} degrés sur {} : les couches y finissent au lieu de la longer</translation>
    </message>
    <message>
        <source>{} mid nodes follow the curved edges beside them less than in proportion: curved elements would be turned over</source>
        <translation>{} nœuds milieux suivent les arêtes courbes voisines moins qu'en proportion : sinon, des éléments courbes seraient retournés</translation>
    </message>
    <message>
        <source>{} mid nodes lie off the shape, by up to {} mm: on it, curved elements would be turned over</source>
        <translation>{} nœuds milieux sont hors de la forme, jusqu'à {} mm : sur elle, des éléments courbes seraient retournés</translation>
    </message>
    <message>
        <source>{} mid nodes of the volume's skin lie off the shape, by up to {} mm: on it, cells would be turned over</source>
        <translation>{} nœuds milieux de la peau du volume sont hors de la forme, jusqu'à {} mm : sur elle, des cellules seraient retournées</translation>
    </message>
    <message>
        <source>{} must be {}, got {}</source>
        <translation>{} : attendu {}, donné {}</translation>
    </message>
    <message>
        <source>{} must be {}, got {} ({})</source>
        <translation>{} : attendu {}, donné {} ({})</translation>
    </message>
    <message>
        <source>{} needs cells: ask for extrude or volume: {}</source>
        <translation>{} a besoin de cellules : demandez extrude ou volume : {}</translation>
    </message>
    <message>
        <source>{} nodes of the initial mesh lay off the shape, by up to {} mm, and were put onto it</source>
        <translation>{} nœuds du maillage initial étaient hors de la forme, jusqu'à {} mm, et y ont été ramenés</translation>
    </message>
    <message>
        <source>{} of {} tetrahedra have an angle below 5 degrees between two sides</source>
        <translation>{} tétraèdres sur {} ont un angle inférieur à 5 degrés entre deux faces</translation>
    </message>
    <message>
        <source>{} on {} got no layers</source>
        <translation>{} sur {} n'a reçu aucune couche</translation>
    </message>
    <message>
        <source>{} on {} got {} complete layers of {}</source>
        <translation>{} sur {} a reçu {} couches complètes sur {}</translation>
    </message>
    <message>
        <source>{} refers to nothing: pick faces or edges for it</source>
        <translation>{} ne se rapporte à rien : choisissez-lui des faces ou des arêtes</translation>
    </message>
    <message>
        <source>{} shape</source>
        <translation>{} forme</translation>
    </message>
    <message>
        <source>{} times, the worst: {}</source>
        <translation>{} fois, le pire : {}</translation>
    </message>
    <message>
        <source>{} volume</source>
        <translation>{} volume</translation>
    </message>
    <message>
        <source>{} was saved by a later version of Advancing Layers (schema {}, here {}): some of its settings may not be seen.</source>
        <translation>{} a été enregistré par une version plus récente d'Advancing Layers (schéma {}, ici {}) : certains réglages ne sont peut-être pas visibles.</translation>
    </message>
    <message>
        <source>{} would cut {} into millions of segments</source>
        <translation>{} couperait {} en millions de segments</translation>
    </message>
    <message>
        <source>{} {}</source>
        <translation>{} : {}</translation>
    </message>
    <message>
        <source>{}, {} and {} exclude each other</source>
        <translation>{}, {} et {} s'excluent</translation>
    </message>
    <message>
        <source>{}, {}, {} and {} are one too many: leave one out</source>
        <translation>{}, {}, {} et {} : une donnée de trop, retirez-en une</translation>
    </message>
    <message>
        <source>{}: OpenCASCADE failed: {}{}</source>
        <translation>{} : OpenCASCADE a échoué : {}{}</translation>
    </message>
    <message>
        <source>{}: an entry lists neither edge nor face</source>
        <translation>{} : une entrée ne nomme ni arête ni face</translation>
    </message>
    <message>
        <source>{}: an entry lists no edge</source>
        <translation>{} : une entrée ne nomme aucune arête</translation>
    </message>
    <message>
        <source>{}: an entry needs a translation or an angle</source>
        <translation>{} : une entrée doit avoir une translation ou un angle</translation>
    </message>
    <message>
        <source>{}: coordinates must be finite</source>
        <translation>{} : les coordonnées doivent être finies</translation>
    </message>
    <message>
        <source>{}: first heights from {} to {} mm, off those asked for ({} mm on average) by up to {} %</source>
        <translation>{} : premières hauteurs de {} à {} mm ; demandé : {} mm en moyenne, écart jusqu'à {} %</translation>
    </message>
    <message>
        <source>{}: its boundary does not enclose a region</source>
        <translation>{} : son contour n'enferme aucune région</translation>
    </message>
    <message>
        <source>{}: its elements reach over edges inside the patch; lower feature_angle to part its faces</source>
        <translation>{} : ses éléments débordent des arêtes intérieures de la partie ; un angle d'arête vive plus petit sépare ses faces</translation>
    </message>
    <message>
        <source>{}: its layers broke the mesh, and it is meshed without them: {}</source>
        <translation>{} : ses couches ont brisé le maillage, et elle est maillée sans elles : {}</translation>
    </message>
    <message>
        <source>{}: its layers broke the mesh: {}</source>
        <translation>{} : ses couches ont rompu le maillage : {}</translation>
    </message>
    <message>
        <source>{}: its segments are fixed: layers run along it where they fit</source>
        <translation>{} : ses segments sont fixés : les couches la longent là où elles tiennent</translation>
    </message>
    <message>
        <source>{}: its sides are one line</source>
        <translation>{} : ses côtés sont une seule ligne</translation>
    </message>
    <message>
        <source>{}: mesh edges of {} and {} join the same two nodes; they are too long</source>
        <translation>{} : des arêtes de maillage de {} et {} joignent les deux mêmes nœuds ; elles sont trop longues</translation>
    </message>
    <message>
        <source>{}: mesh edges of {} cross or touch each other</source>
        <translation>{} : des arêtes de maillage de {} se croisent ou se touchent</translation>
    </message>
    <message>
        <source>{}: mesh edges of {} leave boundary on the wrong side</source>
        <translation>{} : des arêtes de maillage de {} laissent le contour du mauvais côté</translation>
    </message>
    <message>
        <source>{}: no edge lies where {} comes to lie</source>
        <translation>{} : aucune arête ne se trouve où {} arrive</translation>
    </message>
    <message>
        <source>{}: no face lies where {} comes to lie</source>
        <translation>{} : aucune face ne se trouve où {} arrive</translation>
    </message>
    <message>
        <source>{}: no process can be started to read it: {}</source>
        <translation>{} : aucun processus ne peut être lancé pour le lire : {}</translation>
    </message>
    <message>
        <source>{}: point must be finite</source>
        <translation>{} : le point doit être fini</translation>
    </message>
    <message>
        <source>{}: reading the {} file does not end within {} s</source>
        <translation>{} : la lecture du fichier {} ne finit pas en {} s</translation>
    </message>
    <message>
        <source>{}: reading the {} file takes more than {} MB</source>
        <translation>{} : la lecture du fichier {} prend plus de {} Mo</translation>
    </message>
    <message>
        <source>{}: the ending is none of {}</source>
        <translation>{} : l'extension n'est pas l'une de {}</translation>
    </message>
    <message>
        <source>{}: the file cannot be opened</source>
        <translation>{} : le fichier ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>{}: the layers of the faces beside it would cut it differently; its nodes follow the mean, and leave the heights asked for by up to {} %</source>
        <translation>{} : les couches des faces voisines la couperaient différemment ; ses nœuds suivent la moyenne et s'écartent des hauteurs demandées jusqu'à {} %</translation>
    </message>
    <message>
        <source>{}: the mesh of this step is not kept any more: update it.</source>
        <translation>{} : le maillage de cette étape n'est plus conservé : mettez-le à jour.</translation>
    </message>
    <message>
        <source>{}: the panel was closed from outside; its finished mesh was kept.</source>
        <translation>{} : le panneau a été fermé de l'extérieur ; son maillage terminé a été gardé.</translation>
    </message>
    <message>
        <source>{}: the {} file is damaged: its reader crashes on it ({})</source>
        <translation>{} : le fichier {} est endommagé : son lecteur plante ({})</translation>
    </message>
    <message>
        <source>{}: there is no {}, edges of the model: {}</source>
        <translation>{} : {} n'existe pas, arêtes du modèle : {}</translation>
    </message>
    <message>
        <source>{}: there is no {}, faces of the model: {}</source>
        <translation>{} : {} n'existe pas, faces du modèle : {}</translation>
    </message>
    <message>
        <source>{}: triangles more than 30 degrees off the surface: {}; the worst leans by {} degrees</source>
        <translation>{} : triangles à plus de 30 degrés de la surface : {} ; le pire penche de {} degrés</translation>
    </message>
    <message>
        <source>{}: triangles turned over against the surface: {}; the worst leans by {} degrees</source>
        <translation>{} : triangles inversés par rapport à la surface : {} ; le pire penche de {} degrés</translation>
    </message>
    <message>
        <source>{}: {} and {} exclude each other</source>
        <translation>{} : {} et {} s'excluent</translation>
    </message>
    <message>
        <source>{}: {} elements are turned over against the surface</source>
        <translation>{} : {} éléments sont inversés par rapport à la surface</translation>
    </message>
    <message>
        <source>{}: {} elements have an angle below 0.1 degrees</source>
        <translation>{} : {} éléments ont un angle inférieur à 0,1 degré</translation>
    </message>
    <message>
        <source>{}: {} elements have no area</source>
        <translation>{} : {} éléments n'ont pas d'aire</translation>
    </message>
    <message>
        <source>{}: {} elements of layers were changed, as elements there were turned over</source>
        <translation>{} : {} éléments de couches ont été modifiés, car des éléments y étaient inversés</translation>
    </message>
    <message>
        <source>{}: {} elements reach over edges inside the patch; lower feature_angle to part its faces</source>
        <translation>{} : {} éléments débordent des arêtes intérieures de la partie ; un angle d'arête vive plus petit sépare ses faces</translation>
    </message>
    <message>
        <source>{}: {} is a pole without length</source>
        <translation>{} : {} est un pôle sans longueur</translation>
    </message>
    <message>
        <source>{}: {} is a pole without length, nothing grows there</source>
        <translation>{} : {} est un pôle sans longueur, rien n'y croît</translation>
    </message>
    <message>
        <source>{}: {} is listed twice</source>
        <translation>{} : {} est nommée deux fois</translation>
    </message>
    <message>
        <source>{}: {} must bound its patch: {}</source>
        <translation>{} : {} doit border sa partie : {}</translation>
    </message>
    <message>
        <source>{}: {} must not be zero</source>
        <translation>{} : {} ne doit pas être nul</translation>
    </message>
    <message>
        <source>{}: {} needs an edge with two ends, {} is closed</source>
        <translation>{} : {} demande une arête à deux extrémités, {} est fermée</translation>
    </message>
    <message>
        <source>{}: {} nodes lie in the place of another one</source>
        <translation>{} : {} nœuds sont à la place d'un autre</translation>
    </message>
    <message>
        <source>{}: {} touches none of the edges it is listed for ({})</source>
        <translation>{} : {} ne touche aucune des arêtes pour lesquelles elle est nommée ({})</translation>
    </message>
    <message>
        <source>{}; {} is the likest to it</source>
        <translation>{} ; le plus ressemblant est {}</translation>
    </message>
</context>
<context>
    <name>App::Property</name>
    <message>
        <source>2 puts a node in the middle of each mesh edge, on the shape.</source>
        <translation>2 met un nœud au milieu de chaque arête du maillage, sur la forme.</translation>
    </message>
    <message>
        <source>A mesh that is estimated to have more elements is refused before it is begun; 0: two million.</source>
        <translation>Un maillage qui aurait, d’après l’estimation, plus d’éléments est refusé avant d’être commencé ; 0 : deux millions.</translation>
    </message>
    <message>
        <source>A mesh that is estimated to take more megabytes is refused before it is begun; 0: four fifths of the machine's memory.</source>
        <translation>Un maillage qui prendrait, d’après l’estimation, plus de mégaoctets est refusé avant d’être commencé ; 0 : quatre cinquièmes de la mémoire.</translation>
    </message>
    <message>
        <source>A mesh that is estimated to take more seconds of computing is refused before it is begun; 0: ten minutes.</source>
        <translation>Un maillage qui prendrait, d’après l’estimation, plus de secondes de calcul est refusé avant d’être commencé ; 0 : dix minutes.</translation>
    </message>
    <message>
        <source>Air at 15 °C, or water at 20 °C, both at 1 bar.</source>
        <translation>Air à 15 °C ou eau à 20 °C, les deux à 1 bar.</translation>
    </message>
    <message>
        <source>Along a plate, a wing, a hull: the distance from its leading edge. In a pipe or a duct: its hydraulic diameter.</source>
        <translation>Le long d'une plaque, d'une aile, d'une coque : la distance au bord d'attaque. Dans une conduite ou un canal : son diamètre hydraulique.</translation>
    </message>
    <message>
        <source>An existing mesh of the shape to start from. Inside the faces its nodes are where the triangulation starts; where it is finer than size, edges and core become as fine. Its layers and its order do not come over.</source>
        <translation>Un maillage existant de la forme, d'où partir. À l'intérieur des faces, ses nœuds sont le départ de la triangulation ; là où il est plus fin que la taille, les arêtes et le cœur le deviennent aussi. Ses couches et son ordre ne sont pas repris.</translation>
    </message>
    <message>
        <source>Aspect Ratio</source>
        <translation>Rapport d'aspect</translation>
    </message>
    <message>
        <source>Auto Update</source>
        <translation>Mise à jour automatique</translation>
    </message>
    <message>
        <source>Both Ends</source>
        <translation>Deux bouts</translation>
    </message>
    <message>
        <source>Cells Across</source>
        <translation>Éléments en travers</translation>
    </message>
    <message>
        <source>Chord Deviation</source>
        <translation>Écart de corde</translation>
    </message>
    <message>
        <source>Cluster</source>
        <translation>Resserrement</translation>
    </message>
    <message>
        <source>Clusters towards both ends: the ratio is then that of the middle to the ends.</source>
        <translation>Resserre vers les deux bouts : le rapport est alors celui du milieu aux bouts.</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>Core</source>
        <translation>Cœur</translation>
    </message>
    <message>
        <source>Corner angles from 45 to 135 degrees [%].</source>
        <translation>Angles des coins de 45 à 135 degrés [%].</translation>
    </message>
    <message>
        <source>Counts and nodes of the initial mesh that the mesh was made from.</source>
        <translation>Nombres et nœuds du maillage initial dont le maillage est issu.</translation>
    </message>
    <message>
        <source>Curvature Angle</source>
        <translation>Angle de courbure</translation>
    </message>
    <message>
        <source>Density of another fluid [kg/m³].</source>
        <translation>Masse volumique d'un autre fluide [kg/m³].</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Détails</translation>
    </message>
    <message>
        <source>Dimensionless height of the first layer; its middle lies at half of it.</source>
        <translation>Hauteur sans dimension de la première couche ; son milieu est à la moitié.</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Répartition</translation>
    </message>
    <message>
        <source>Dynamic viscosity of another fluid [Pa s].</source>
        <translation>Viscosité dynamique d'un autre fluide [Pa s].</translation>
    </message>
    <message>
        <source>Each layer is this much higher than the one before it.</source>
        <translation>Chaque couche est plus haute que la précédente de ce facteur.</translation>
    </message>
    <message>
        <source>Each layer of this wall is this much higher than the one before it.</source>
        <translation>Chaque couche de cette paroi est plus haute que la précédente de ce facteur.</translation>
    </message>
    <message>
        <source>Each layer of this wall is this much higher than the one before it. 0: not given.</source>
        <translation>Chaque couche de cette paroi est plus haute que la précédente de ce facteur. 0 : non précisé.</translation>
    </message>
    <message>
        <source>Edge Segments</source>
        <translation>Segments d’arêtes</translation>
    </message>
    <message>
        <source>Edge length of the mesh away from the layers. Default: 1/40 of the diagonal of the shape's bounding box.</source>
        <translation>Longueur des arêtes du maillage hors des couches. Par défaut : 1/40 de la diagonale de la boîte englobante de la forme.</translation>
    </message>
    <message>
        <source>Edge length of the mesh.</source>
        <translation>Longueur des arêtes du maillage.</translation>
    </message>
    <message>
        <source>Edge length of the mesh. 0: not given.</source>
        <translation>Longueur des arêtes du maillage. 0 : non précisé.</translation>
    </message>
    <message>
        <source>Edges and faces that a motion brings onto others: these are cut and meshed as copies of those; as a property, texts: Face1 move x y z, or Edge1 Edge2 turn x y z x y z angle, with a point on the axis and its direction.</source>
        <translation>Arêtes et faces qu'un mouvement amène sur d'autres : celles-ci sont découpées et maillées comme des copies de celles-là ; comme propriété, des textes : Face1 move x y z, ou Edge1 Edge2 turn x y z x y z angle, avec un point de l'axe et sa direction.</translation>
    </message>
    <message>
        <source>Element Layers</source>
        <translation>Couches des éléments</translation>
    </message>
    <message>
        <source>Elements turned over against the surface.</source>
        <translation>Éléments inversés par rapport à la surface.</translation>
    </message>
    <message>
        <source>End Height</source>
        <translation>Hauteur finale</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Faces</translation>
    </message>
    <message>
        <source>Faces that meet at an angle below this are meshed as one patch; layers run across the edge between them. 0 makes every CAD face a patch of its own; an STL file is meshed with 20.</source>
        <translation>Les faces qui se rencontrent sous un angle plus petit sont maillées d'un seul tenant ; les couches traversent l'arête entre elles. Avec 0, chaque face CAO est maillée pour elle-même ; un fichier STL est maillé avec 20.</translation>
    </message>
    <message>
        <source>Faces whose edges lie within this distance of each other are joined there before meshing; 0 joins none. Faces and edges keep their names.</source>
        <translation>Les faces dont les arêtes sont à cette distance au plus l’une de l’autre y sont jointes avant le maillage ; 0 n’en joint aucune. Faces et arêtes gardent leurs noms.</translation>
    </message>
    <message>
        <source>Faces with four sides that are filled with rows and columns of quads from side to side, with the layers of walls along them; facing sides get as many mesh edges.</source>
        <translation>Faces à quatre côtés remplies de rangées et de colonnes de quadrangles d'un côté à l'autre, avec les couches des parois le long d'eux ; les côtés opposés reçoivent autant d'arêtes du maillage.</translation>
    </message>
    <message>
        <source>Feature Angle</source>
        <translation>Angle d'arête vive</translation>
    </message>
    <message>
        <source>First Height</source>
        <translation>Première hauteur</translation>
    </message>
    <message>
        <source>First Segment</source>
        <translation>Premier segment</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Géométrie</translation>
    </message>
    <message>
        <source>Good Angle Percent</source>
        <translation>Bons angles [%]</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Groupe</translation>
    </message>
    <message>
        <source>Group List</source>
        <translation>Groupes</translation>
    </message>
    <message>
        <source>Group Name</source>
        <translation>Nom du groupe</translation>
    </message>
    <message>
        <source>Grow From All</source>
        <translation>Depuis toutes les arêtes</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Croissance</translation>
    </message>
    <message>
        <source>Height Errors</source>
        <translation>Erreurs de hauteur</translation>
    </message>
    <message>
        <source>Height of all layers together. With two of first_height, growth and layers it gives the third; where fewer are given, those of the whole mesh stand in, and layers are worked out first.</source>
        <translation>Hauteur de toutes les couches ensemble. Avec deux données parmi la première hauteur, la croissance et le nombre de couches, elle donne la troisième ; s'il y en a moins, celles de tout le maillage les remplacent, et le nombre de couches est calculé d'abord.</translation>
    </message>
    <message>
        <source>Height of all layers together. With two of first_height, growth and layers it gives the third; where fewer are given, those of the whole mesh stand in, and layers are worked out first. 0: not given.</source>
        <translation>Hauteur de toutes les couches ensemble. Avec deux données parmi la première hauteur, la croissance et le nombre de couches, elle donne la troisième ; s'il y en a moins, celles de tout le maillage les remplacent, et le nombre de couches est calculé d'abord. 0 : non précisé.</translation>
    </message>
    <message>
        <source>Height of the first layer, measured along the surface. Default: 1/10 of size.</source>
        <translation>Hauteur de la première couche, mesurée le long de la surface. Par défaut : 1/10 de la taille.</translation>
    </message>
    <message>
        <source>Height of this wall's first layer.</source>
        <translation>Hauteur de la première couche de cette paroi.</translation>
    </message>
    <message>
        <source>Height of this wall's first layer. 0: not given.</source>
        <translation>Hauteur de la première couche de cette paroi. 0 : non précisé.</translation>
    </message>
    <message>
        <source>How far the height of each element of a layer is from the one asked for, relative to it; NaN for the core.</source>
        <translation>Écart de la hauteur de chaque élément d'une couche à celle demandée, rapporté à celle-ci ; NaN pour le cœur.</translation>
    </message>
    <message>
        <source>How mesh edges grow between first and last segment: smoothly towards both, in geometric steps, or not at all beyond one step.</source>
        <translation>Comment croissent les arêtes du maillage entre le premier et le dernier segment : en douceur vers les deux, par pas géométriques, ou pas du tout après un pas.</translation>
    </message>
    <message>
        <source>Initial Mesh</source>
        <translation>Maillage initial</translation>
    </message>
    <message>
        <source>Instead of first_height: the angle that the wall turns over a length of one first height; the height is size where the wall is straight.</source>
        <translation>Au lieu de la première hauteur : l'angle dont la paroi tourne sur la longueur d'une première hauteur ; où la paroi est droite, la hauteur est la taille.</translation>
    </message>
    <message>
        <source>Instead of first_height: the angle that the wall turns over a length of one first height; the height is size where the wall is straight. 0: not given.</source>
        <translation>Au lieu de la première hauteur : l'angle dont la paroi tourne sur la longueur d'une première hauteur ; où la paroi est droite, la hauteur est la taille. 0 : non précisé.</translation>
    </message>
    <message>
        <source>Instead of first_height: the length of the mesh edges along the wall over the first height, everywhere.</source>
        <translation>Au lieu de la première hauteur : la longueur des arêtes du maillage le long de la paroi divisée par la première hauteur, partout.</translation>
    </message>
    <message>
        <source>Instead of first_height: the length of the mesh edges along the wall over the first height, everywhere. 0: not given.</source>
        <translation>Au lieu de la première hauteur : la longueur des arêtes du maillage le long de la paroi divisée par la première hauteur, partout. 0 : non précisé.</translation>
    </message>
    <message>
        <source>Instead of thickness: the height of all layers together over the size along the edge.</source>
        <translation>Au lieu de thickness : la hauteur de toutes les couches ensemble, divisée par la taille le long de l'arête.</translation>
    </message>
    <message>
        <source>Instead of thickness: the height of all layers together over the size along the edge. 0: not given.</source>
        <translation>Au lieu de thickness : la hauteur de toutes les couches ensemble, divisée par la taille le long de l'arête. 0 : non précisé.</translation>
    </message>
    <message>
        <source>Inverted Count</source>
        <translation>Éléments inversés</translation>
    </message>
    <message>
        <source>Last Segment</source>
        <translation>Dernier segment</translation>
    </message>
    <message>
        <source>Layer Groups</source>
        <translation>Groupes des couches</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Couches</translation>
    </message>
    <message>
        <source>Layers grow from every boundary edge, as long as no Wall of the mesh says otherwise.</source>
        <translation>Les couches croissent depuis chaque arête de bord, tant qu'aucune paroi du maillage ne dit autre chose.</translation>
    </message>
    <message>
        <source>Length of the first mesh edge at the first vertex of each CAD edge.</source>
        <translation>Longueur de la première arête du maillage au premier sommet de chaque arête CAO.</translation>
    </message>
    <message>
        <source>Length of the first mesh edge at the first vertex of each CAD edge. 0: not given.</source>
        <translation>Longueur de la première arête du maillage au premier sommet de chaque arête CAO. 0 : non précisé.</translation>
    </message>
    <message>
        <source>Length of the last mesh edge at the last vertex of each CAD edge.</source>
        <translation>Longueur de la dernière arête du maillage au dernier sommet de chaque arête CAO.</translation>
    </message>
    <message>
        <source>Length of the last mesh edge at the last vertex of each CAD edge. 0: not given.</source>
        <translation>Longueur de la dernière arête du maillage au dernier sommet de chaque arête CAO. 0 : non précisé.</translation>
    </message>
    <message>
        <source>Makes a group of the elements of each layer, too: Layer1, Layer2, … and Core.</source>
        <translation>Fait aussi un groupe des éléments de chaque couche : Layer1, Layer2, … et Core.</translation>
    </message>
    <message>
        <source>Mapped</source>
        <translation>Réglées</translation>
    </message>
    <message>
        <source>Max Angle</source>
        <translation>Angle maximal</translation>
    </message>
    <message>
        <source>Max Elements</source>
        <translation>Éléments au plus</translation>
    </message>
    <message>
        <source>Max Memory</source>
        <translation>Mémoire au plus</translation>
    </message>
    <message>
        <source>Max Seconds</source>
        <translation>Secondes au plus</translation>
    </message>
    <message>
        <source>Mesh Id</source>
        <translation>Identifiant du maillage</translation>
    </message>
    <message>
        <source>Mesh edges on CAD edges: the edge and two nodes, counted from 0, of each.</source>
        <translation>Arêtes du maillage sur les arêtes CAO : de chacune l’arête et deux nœuds, comptés à partir de 0.</translation>
    </message>
    <message>
        <source>Meshed Constraints</source>
        <translation>Conditions maillées</translation>
    </message>
    <message>
        <source>Meshed Initial Mesh</source>
        <translation>Maillage initial employé</translation>
    </message>
    <message>
        <source>Meshed Settings</source>
        <translation>Réglages employés</translation>
    </message>
    <message>
        <source>Meshed Shape</source>
        <translation>Forme maillée</translation>
    </message>
    <message>
        <source>Meshes again whenever a recompute finds the mesh out of date.</source>
        <translation>Remaille chaque fois qu'un recalcul trouve le maillage obsolète.</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>Min Angle</source>
        <translation>Angle minimal</translation>
    </message>
    <message>
        <source>Min Size</source>
        <translation>Taille minimale</translation>
    </message>
    <message>
        <source>Node Count</source>
        <translation>Nombre de nœuds</translation>
    </message>
    <message>
        <source>Node Layers</source>
        <translation>Couches des nœuds</translation>
    </message>
    <message>
        <source>Node Parents</source>
        <translation>Parents des nœuds</translation>
    </message>
    <message>
        <source>Nodes of the mesh.</source>
        <translation>Nœuds du maillage.</translation>
    </message>
    <message>
        <source>Number of layers; 0 grows them until the fronts close; "isotropic" grows each until its height reaches the spacing along the wall.</source>
        <translation>Nombre de couches ; avec 0, elles croissent jusqu'à ce que les fronts se ferment ; avec « isotropic », jusqu'à ce que leur hauteur atteigne l'espacement le long de la paroi.</translation>
    </message>
    <message>
        <source>Number of mesh edges along each of the edges.</source>
        <translation>Nombre d'arêtes du maillage le long de chacune des arêtes.</translation>
    </message>
    <message>
        <source>Number of mesh edges along each of the edges. 0: not given.</source>
        <translation>Nombre d'arêtes du maillage le long de chacune des arêtes. 0 : non précisé.</translation>
    </message>
    <message>
        <source>Number of this wall's layers; 0 grows them until the fronts close.</source>
        <translation>Nombre de couches de cette paroi ; avec 0, elles croissent jusqu'à ce que les fronts se ferment.</translation>
    </message>
    <message>
        <source>Number of this wall's layers; 0 grows them until the fronts close. -1: not given.</source>
        <translation>Nombre de couches de cette paroi ; avec 0, elles croissent jusqu'à ce que les fronts se ferment. -1 : non précisé.</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Autres</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Past a plate, or developed in a pipe.</source>
        <translation>Le long d'une plaque, ou établi dans une conduite.</translation>
    </message>
    <message>
        <source>Periodic</source>
        <translation>Périodiques</translation>
    </message>
    <message>
        <source>Picked</source>
        <translation>Choisi</translation>
    </message>
    <message>
        <source>Points of the shape that was meshed.</source>
        <translation>Points de la forme maillée.</translation>
    </message>
    <message>
        <source>Points, lines and boxes about which the mesh is finer; as a property, texts: x y z size radius, or line x y z x y z size radius, or box x y z x y z size radius.</source>
        <translation>Points, segments et boîtes autour desquels le maillage est plus fin ; comme propriété, des textes : x y z taille rayon, ou line x y z x y z taille rayon, ou box x y z x y z taille rayon.</translation>
    </message>
    <message>
        <source>Quad Count</source>
        <translation>Nombre de quadrangles</translation>
    </message>
    <message>
        <source>Quad Percent</source>
        <translation>Quadrangles [%]</translation>
    </message>
    <message>
        <source>Quads among all elements [%].</source>
        <translation>Quadrangles parmi tous les éléments [%].</translation>
    </message>
    <message>
        <source>Quads of the mesh.</source>
        <translation>Quadrangles du maillage.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Ratio of the last mesh edge along a CAD edge to the first, in geometric steps.</source>
        <translation>Rapport de la dernière arête du maillage le long d'une arête CAO à la première, par pas géométriques.</translation>
    </message>
    <message>
        <source>Ratio of the last mesh edge along a CAD edge to the first, in geometric steps. 0: not given.</source>
        <translation>Rapport de la dernière arête du maillage le long d'une arête CAO à la première, par pas géométriques. 0 : non précisé.</translation>
    </message>
    <message>
        <source>References</source>
        <translation>Références</translation>
    </message>
    <message>
        <source>Refinements</source>
        <translation>Raffinements</translation>
    </message>
    <message>
        <source>Relative Chord</source>
        <translation>Corde relative</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Exécution</translation>
    </message>
    <message>
        <source>Schema Version</source>
        <translation>Version du schéma</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segments</translation>
    </message>
    <message>
        <source>Sew Tolerance</source>
        <translation>Tolérance de couture</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Size Growth</source>
        <translation>Progression des tailles</translation>
    </message>
    <message>
        <source>Size List</source>
        <translation>Tailles</translation>
    </message>
    <message>
        <source>Speed of the flow [m/s].</source>
        <translation>Vitesse de l'écoulement [m/s].</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Tells this mesh from the ones before it.</source>
        <translation>Distingue ce maillage des précédents.</translation>
    </message>
    <message>
        <source>The CAD faces to mesh, by name, or all of them.</source>
        <translation>Les faces CAO à mailler, par leur nom, ou toutes.</translation>
    </message>
    <message>
        <source>The constraints of analyses that the mesh has groups for, each with its faces.</source>
        <translation>Les conditions des analyses pour lesquelles le maillage a des groupes, chacune avec ses faces.</translation>
    </message>
    <message>
        <source>The edges that the values hold for. With faces too: only on the side of those faces. Faces alone: all their boundary edges, on their side.</source>
        <translation>Les arêtes pour lesquelles valent les valeurs. Avec des faces : seulement du côté de ces faces. Des faces seules : toutes leurs arêtes de bord, de leur côté.</translation>
    </message>
    <message>
        <source>The faces and edges of the group; the mesh groups them under its label.</source>
        <translation>Les faces et arêtes du groupe ; le maillage les regroupe sous son étiquette.</translation>
    </message>
    <message>
        <source>The faces, edges and vertices that the size holds for.</source>
        <translation>Les faces, arêtes et sommets pour lesquels vaut la taille.</translation>
    </message>
    <message>
        <source>The first height at the end of each edge; it changes linearly along the edge, from first_height at its first vertex.</source>
        <translation>La première hauteur à la fin de chaque arête ; elle change linéairement le long de l'arête, à partir de la première hauteur à son premier sommet.</translation>
    </message>
    <message>
        <source>The first height at the end of each edge; it changes linearly along the edge, from first_height at its first vertex. 0: not given.</source>
        <translation>La première hauteur à la fin de chaque arête ; elle change linéairement le long de l'arête, à partir de la première hauteur à son premier sommet. 0 : non précisé.</translation>
    </message>
    <message>
        <source>The group's name in the mesh; the label, unless another is given here.</source>
        <translation>Le nom du groupe dans le maillage ; l'étiquette, sauf si un autre est donné ici.</translation>
    </message>
    <message>
        <source>The largest corner angle.</source>
        <translation>Le plus grand angle de coin.</translation>
    </message>
    <message>
        <source>The layer of each element; 0 for the core.</source>
        <translation>La couche de chaque élément ; 0 pour le cœur.</translation>
    </message>
    <message>
        <source>The layer that each node was extruded in; else 0.</source>
        <translation>La couche dans laquelle chaque nœud a été extrudé ; sinon 0.</translation>
    </message>
    <message>
        <source>The least edge length that curvature and chords may ask for; 0: any. Sizes of edges, faces and regions are not held to it.</source>
        <translation>La plus petite longueur d'arête que la courbure et les cordes peuvent demander ; 0 : toute. Les tailles des arêtes, des faces et des régions n'y sont pas tenues.</translation>
    </message>
    <message>
        <source>The least number of elements over the extent of each face, however small it is beside the whole, down to a tenth of size; a small outline inside a plane face, such as an airfoil in its domain, gets twelve times as many around it, fewer where there are several. First heights of a tenth of size or more are held to a tenth of the mesh edges along their wall. 0: none. Default: 10 where neither size nor first_height is given.</source>
        <translation>Le plus petit nombre d'éléments sur l'étendue de chaque face, si petite soit-elle à côté du tout, jusqu'à un dixième de la taille ; un petit contour dans une face plane, comme un profil dans son domaine, en reçoit douze fois autant autour de lui, moins s'il y en a plusieurs. Les premières hauteurs d'un dixième de la taille ou plus sont ramenées à un dixième des arêtes du maillage le long de leur paroi. 0 : aucun. Par défaut : 10 si ni size ni first_height n'est donné.</translation>
    </message>
    <message>
        <source>The local sizes of the mesh.</source>
        <translation>Les tailles locales du maillage.</translation>
    </message>
    <message>
        <source>The most that neighbouring mesh edges differ in length where the size changes, through the surface and along edges.</source>
        <translation>Le plus grand rapport de longueur d'arêtes voisines du maillage où la taille change, à travers la surface et le long des arêtes.</translation>
    </message>
    <message>
        <source>The most that one element edge may turn along a curved edge or face; finer than size where the shape is curved.</source>
        <translation>De combien au plus une arête d'élément peut tourner le long d'une arête ou d'une face courbe ; plus fin que la taille où la forme est courbe.</translation>
    </message>
    <message>
        <source>The most that the middle of a mesh edge may lie off the curve or surface that it stands for; 0: any.</source>
        <translation>Écart maximal du milieu d'une arête du maillage à la courbe ou à la surface qu'elle représente ; 0 : quelconque.</translation>
    </message>
    <message>
        <source>The named groups of the mesh.</source>
        <translation>Les groupes nommés du maillage.</translation>
    </message>
    <message>
        <source>The node, counted from 0, that each node was extruded from; else -1.</source>
        <translation>Le nœud, compté à partir de 0, dont chaque nœud a été extrudé ; sinon -1.</translation>
    </message>
    <message>
        <source>The object that is meshed.</source>
        <translation>L'objet qui est maillé.</translation>
    </message>
    <message>
        <source>The object whose faces are meshed.</source>
        <translation>L'objet dont les faces sont maillées.</translation>
    </message>
    <message>
        <source>The report of the mesh, as a job writes it.</source>
        <translation>Le rapport du maillage, tel que l'écrit une tâche par lots.</translation>
    </message>
    <message>
        <source>The same over the length of the mesh edge; 0: any.</source>
        <translation>Le même, divisé par la longueur de l'arête du maillage ; 0 : quelconque.</translation>
    </message>
    <message>
        <source>The settings that the mesh was made with.</source>
        <translation>Les réglages avec lesquels le maillage a été fait.</translation>
    </message>
    <message>
        <source>The size holds within this distance of the point.</source>
        <translation>La taille vaut jusqu'à cette distance du point.</translation>
    </message>
    <message>
        <source>The smallest corner angle.</source>
        <translation>Le plus petit angle de coin.</translation>
    </message>
    <message>
        <source>The walls of the mesh.</source>
        <translation>Les parois du maillage.</translation>
    </message>
    <message>
        <source>The way in which the object keeps its data.</source>
        <translation>La façon dont l'objet conserve ses données.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Thickness Share</source>
        <translation>Part d'épaisseur</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Fils d'exécution</translation>
    </message>
    <message>
        <source>Threads to mesh with; 0 uses all processors. The mesh does not depend on it.</source>
        <translation>Fils d'exécution pour mailler ; 0 utilise tous les processeurs. Le maillage n'en dépend pas.</translation>
    </message>
    <message>
        <source>Triangle Count</source>
        <translation>Nombre de triangles</translation>
    </message>
    <message>
        <source>Triangles of the mesh.</source>
        <translation>Triangles du maillage.</translation>
    </message>
    <message>
        <source>Turning Angle</source>
        <translation>Angle de rotation</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Paroi</translation>
    </message>
    <message>
        <source>Wall List</source>
        <translation>Parois</translation>
    </message>
    <message>
        <source>Wall: layers grow from the edges. Match: layers of other walls run along them. Off: neither. Boundary: they bound their faces, however smoothly these meet. Smooth: layers run across them.</source>
        <translation>Paroi (Wall) : des couches croissent des arêtes. Suivre (Match) : les couches d’autres parois les longent. Sans (Off) : ni l’un ni l’autre. Bord (Boundary) : elles bordent leurs faces, si lisse que soit leur raccord. Lisse (Smooth) : les couches les traversent.</translation>
    </message>
    <message>
        <source>What becomes of boundary edges that a list of walls leaves out: those that meet a wall are match edges, or all are off, or all are walls of the mesh's own values.</source>
        <translation>Ce que deviennent les arêtes de bord qu'une liste de parois laisse de côté : celles qui touchent une paroi sont des arêtes de raccord (match), ou toutes sont sans effet (off), ou toutes sont des parois aux valeurs du maillage (wall).</translation>
    </message>
    <message>
        <source>What fills the part that no layer reaches: quads where they come out well, or triangles.</source>
        <translation>Ce qui remplit la partie qu'aucune couche n'atteint : des quadrangles où ils sont bons, ou des triangles.</translation>
    </message>
    <message>
        <source>What is asked for where nothing else is said: cfd grows layers from every sharp edge until they are as high as wide, fem has none, washers puts two rings of quads about every hole.</source>
        <translation>Ce qui vaut là où rien d'autre n'est dit : CFD fait croître des couches depuis chaque arête vive jusqu'à ce qu'elles soient aussi hautes que larges, EF n'en a pas, rondelles met deux anneaux de quadrilatères autour de chaque trou.</translation>
    </message>
    <message>
        <source>What the faces looked like when they were picked.</source>
        <translation>À quoi ressemblaient les faces quand elles ont été choisies.</translation>
    </message>
    <message>
        <source>What the mesher had to say.</source>
        <translation>Ce que le mailleur avait à dire.</translation>
    </message>
    <message>
        <source>What the references looked like when they were picked.</source>
        <translation>À quoi ressemblaient les références quand elles ont été choisies.</translation>
    </message>
    <message>
        <source>Whether the mesh fits the settings and the shape.</source>
        <translation>Si le maillage correspond aux réglages et à la forme.</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Advancing Layers</source>
        <translation>Advancing Layers</translation>
    </message>
</context>
</TS>
