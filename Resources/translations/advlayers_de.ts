<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AdvLayersPreferences</name>
    <message>
        <source> deg</source>
        <translation> Grad</translation>
    </message>
    <message>
        <source>Core</source>
        <translation>Kern</translation>
    </message>
    <message>
        <source>Curvature angle</source>
        <translation>Krümmungswinkel</translation>
    </message>
    <message>
        <source>Defaults of a new layer mesh</source>
        <translation>Vorgaben für ein neues Schichtnetz</translation>
    </message>
    <message>
        <source>Draw the layers as they grow</source>
        <translation>Die Schichten zeichnen, während sie wachsen</translation>
    </message>
    <message>
        <source>Each layer of a new mesh is this much higher than the one before it.</source>
        <translation>Jede Schicht eines neuen Netzes ist um diesen Faktor höher als die vorige.</translation>
    </message>
    <message>
        <source>Faces that meet at an angle below this are meshed as one patch.</source>
        <translation>Flächen, die sich in einem kleineren Winkel treffen, werden als eine Teilfläche vernetzt.</translation>
    </message>
    <message>
        <source>Feature angle</source>
        <translation>Kantenwinkel</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Grow until isotropic</source>
        <translation>Wachsen, bis isotrop</translation>
    </message>
    <message>
        <source>Grows each layer of a new mesh until its height reaches the spacing along the wall.</source>
        <translation>Lässt die Schichten eines neuen Netzes wachsen, bis ihre Höhe den Abstand entlang der Wand erreicht.</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Wachstum</translation>
    </message>
    <message>
        <source>How often the growing mesh is drawn, at most.</source>
        <translation>Wie oft das wachsende Netz höchstens gezeichnet wird.</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Meshing</source>
        <translation>Vernetzung</translation>
    </message>
    <message>
        <source>Number of layers of a new mesh; 0 grows them until the fronts close.</source>
        <translation>Zahl der Schichten eines neuen Netzes; bei 0 wachsen sie, bis die Fronten sich schließen.</translation>
    </message>
    <message>
        <source>Pictures per second</source>
        <translation>Bilder je Sekunde</translation>
    </message>
    <message>
        <source>Shows the mesh in the 3D view while it is being made.</source>
        <translation>Zeigt das Netz in der 3D-Ansicht, während es entsteht.</translation>
    </message>
    <message>
        <source>The most that one element edge may turn along a curved edge or face.</source>
        <translation>Um wie viel sich eine Elementkante entlang einer gekrümmten Kante oder Fläche höchstens drehen darf.</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>Threads to mesh with; 0 uses all processors. The mesh does not depend on it.</source>
        <translation>Threads für die Vernetzung; 0 nutzt alle Prozessoren. Das Netz hängt nicht davon ab.</translation>
    </message>
    <message>
        <source>What fills the part of a new mesh that no layer reaches.</source>
        <translation>Was den Teil eines neuen Netzes füllt, den keine Schicht erreicht.</translation>
    </message>
    <message>
        <source>quads</source>
        <translation>Vierecke</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Check</name>
    <message>
        <source>Check Mesh</source>
        <translation>Netz prüfen</translation>
    </message>
    <message>
        <source>Lists what is to be said about the mesh: lost references, diagnostics, worst elements</source>
        <translation>Listet auf, was über das Netz zu sagen ist: verlorene Bezüge, Meldungen, schlechteste Elemente</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Export</name>
    <message>
        <source>Export Mesh…</source>
        <translation>Netz exportieren…</translation>
    </message>
    <message>
        <source>Writes the mesh to a file with all of its quads, triangles and groups</source>
        <translation>Schreibt das Netz mit allen Vierecken, Dreiecken und Gruppen in eine Datei</translation>
    </message>
</context>
<context>
    <name>AdvLayers_FillVolume</name>
    <message>
        <source>Fill with Tetrahedra</source>
        <translation>Mit Tetraedern füllen</translation>
    </message>
    <message>
        <source>Fills the inside of a closed layer mesh with tetrahedra, using Gmsh</source>
        <translation>Füllt das Innere eines geschlossenen Schichtnetzes mit Tetraedern, mit Hilfe von Gmsh</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Group</name>
    <message>
        <source>Groups the selected faces and edges under a name, for boundary conditions: the label of the new object, which may be changed</source>
        <translation>Fasst die gewählten Flächen und Kanten unter einem Namen zusammen, für Randbedingungen: der Bezeichnung des neuen Objekts, die geändert werden kann</translation>
    </message>
    <message>
        <source>Named Group</source>
        <translation>Benannte Gruppe</translation>
    </message>
</context>
<context>
    <name>AdvLayers_LayerMesh</name>
    <message>
        <source>Creates a quad-dominant surface mesh of the selected shape or faces, with layers along its edges</source>
        <translation>Erzeugt ein Oberflächennetz, vorwiegend aus Vierecken, der gewählten Form oder Flächen, mit Schichten entlang ihrer Kanten</translation>
    </message>
    <message>
        <source>Layer Mesh…</source>
        <translation>Schichtnetz…</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Size</name>
    <message>
        <source>Sets the size of the mesh on the selected faces and edges</source>
        <translation>Legt die Elementgröße auf den gewählten Flächen und Kanten fest</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Elementgröße</translation>
    </message>
</context>
<context>
    <name>AdvLayers_TakeOver</name>
    <message>
        <source>Makes a layer mesh with the sizes, boundary layers, regions and groups of the selected Gmsh mesh, and puts it in its place in the analysis</source>
        <translation>Macht ein Schichtnetz mit den Größen, Grenzschichten, Bereichen und Gruppen des gewählten Gmsh-Netzes und setzt es in der Analyse an dessen Stelle</translation>
    </message>
    <message>
        <source>Take over from Gmsh Mesh</source>
        <translation>Von Gmsh-Netz übernehmen</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ToMesh</name>
    <message>
        <source>Convert to Triangles</source>
        <translation>In Dreiecke umwandeln</translation>
    </message>
    <message>
        <source>Makes a Mesh object of the layer mesh, each quad as two triangles</source>
        <translation>Macht aus dem Schichtnetz ein Mesh-Objekt, jedes Viereck als zwei Dreiecke</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Update</name>
    <message>
        <source>Meshes the selected layer meshes again, or all of the document that are out of date</source>
        <translation>Vernetzt die gewählten Schichtnetze neu, oder alle veralteten des Dokuments</translation>
    </message>
    <message>
        <source>Update Mesh</source>
        <translation>Netz aktualisieren</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Wall</name>
    <message>
        <source>Gives the selected edges, or the edges of the selected faces, layers of their own height, growth and number</source>
        <translation>Gibt den gewählten Kanten, oder den Kanten der gewählten Flächen, Schichten mit eigener Höhe, eigenem Wachstum und eigener Zahl</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
</context>
<context>
    <name>AdvancingLayers</name>
    <message>
        <source>Export Mesh</source>
        <translation>Netz exportieren</translation>
    </message>
    <message>
        <source>Select faces or edges of the meshed shape first.</source>
        <translation>Wählen Sie zuerst Flächen oder Kanten der vernetzten Form.</translation>
    </message>
    <message>
        <source>Select one Gmsh mesh first.</source>
        <translation>Wählen Sie zuerst ein Gmsh-Netz.</translation>
    </message>
    <message>
        <source>Select one layer mesh first.</source>
        <translation>Wählen Sie zuerst ein Schichtnetz.</translation>
    </message>
    <message>
        <source>Select the layer mesh as well: there are several.</source>
        <translation>Wählen Sie auch das Schichtnetz: es gibt mehrere.</translation>
    </message>
    <message>
        <source>Select the shape to mesh, or some of its faces, first.</source>
        <translation>Wählen Sie zuerst die Form, die zu vernetzen ist, oder einige ihrer Flächen.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>There is nothing to complain of.</source>
        <translation>Es gibt nichts zu beanstanden.</translation>
    </message>
    <message>
        <source>{label}: layer {layer}, {elements} elements, {seconds} s</source>
        <translation>{label}: Schicht {layer}, {elements} Elemente, {seconds} s</translation>
    </message>
</context>
<context>
    <name>App::Property</name>
    <message>
        <source>As above, for this wall. 0: not given.</source>
        <translation>Wie oben, für diese Wand. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>As above, for this wall: a number. -1: not given.</source>
        <translation>Wie oben, für diese Wand: eine Zahl. -1: nicht angegeben.</translation>
    </message>
    <message>
        <source>Corner angles from 45 to 135 degrees [%].</source>
        <translation>Eckenwinkel von 45 bis 135 Grad [%].</translation>
    </message>
    <message>
        <source>Each layer is this much higher than the one before it.</source>
        <translation>Jede Schicht ist um diesen Faktor höher als die vorige.</translation>
    </message>
    <message>
        <source>Edge length of the mesh away from the layers. Default: 1/40 of the diagonal of the shape's bounding box.</source>
        <translation>Kantenlänge des Netzes abseits der Schichten. Vorgabe: 1/40 der Diagonale des Hüllquaders der Form.</translation>
    </message>
    <message>
        <source>Edge length of the mesh. 0: not given.</source>
        <translation>Kantenlänge des Netzes. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Elements turned over against the surface.</source>
        <translation>Gegen die Oberfläche umgeklappte Elemente.</translation>
    </message>
    <message>
        <source>Faces that meet at an angle below this are meshed as one patch; layers run across the edge between them. 0 makes every CAD face a patch of its own; an STL file is meshed with 20.</source>
        <translation>Flächen, die sich in einem kleineren Winkel treffen, werden als eine Teilfläche vernetzt; Schichten laufen über die Kante zwischen ihnen hinweg. Bei 0 ist jede CAD-Fläche eine Teilfläche für sich; eine STL-Datei wird mit 20 vernetzt.</translation>
    </message>
    <message>
        <source>Height of the first layer, measured along the surface. Default: 1/10 of size.</source>
        <translation>Höhe der ersten Schicht, entlang der Oberfläche gemessen. Vorgabe: 1/10 der Elementgröße.</translation>
    </message>
    <message>
        <source>How far the height of each element of a layer is from the one asked for, relative to it; NaN for the core.</source>
        <translation>Wie weit die Höhe jedes Elements einer Schicht von der verlangten abweicht, bezogen auf diese; NaN für den Kern.</translation>
    </message>
    <message>
        <source>Layers grow from every boundary edge, as long as no Wall of the mesh says otherwise.</source>
        <translation>Schichten wachsen von jeder Randkante, solange keine Wand des Netzes anderes sagt.</translation>
    </message>
    <message>
        <source>Meshes again whenever a recompute finds the mesh out of date.</source>
        <translation>Vernetzt neu, sooft eine Neuberechnung das Netz veraltet findet.</translation>
    </message>
    <message>
        <source>Nodes of the mesh.</source>
        <translation>Knoten des Netzes.</translation>
    </message>
    <message>
        <source>Number of layers; 0 grows them until the fronts close; "isotropic" grows each until its height reaches the spacing along the wall.</source>
        <translation>Zahl der Schichten; bei 0 wachsen sie, bis die Fronten sich schließen; bei "isotropic", bis ihre Höhe den Abstand entlang der Wand erreicht.</translation>
    </message>
    <message>
        <source>Number of mesh edges along each of the edges. 0: not given.</source>
        <translation>Zahl der Netzkanten entlang jeder der Kanten. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Points of the shape that was meshed.</source>
        <translation>Punkte der vernetzten Form.</translation>
    </message>
    <message>
        <source>Quads among all elements [%].</source>
        <translation>Anteil der Vierecke an allen Elementen [%].</translation>
    </message>
    <message>
        <source>Quads of the mesh.</source>
        <translation>Vierecke des Netzes.</translation>
    </message>
    <message>
        <source>Ratio of the last mesh edge along a CAD edge to the first. 0: not given.</source>
        <translation>Verhältnis der letzten Netzkante entlang einer CAD-Kante zur ersten. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Tells this mesh from the ones before it.</source>
        <translation>Unterscheidet dieses Netz von den vorigen.</translation>
    </message>
    <message>
        <source>The CAD faces to mesh, by name, or all of them.</source>
        <translation>Die zu vernetzenden CAD-Flächen, mit Namen, oder alle.</translation>
    </message>
    <message>
        <source>The edges that the values hold for. With faces too: only on the side of those faces. Faces alone: all their boundary edges, on their side.</source>
        <translation>Die Kanten, für die die Werte gelten. Mit Flächen dazu: nur auf der Seite dieser Flächen. Flächen allein: alle ihre Randkanten, auf ihrer Seite.</translation>
    </message>
    <message>
        <source>The faces and edges of the group; the mesh groups them under its label.</source>
        <translation>Die Flächen und Kanten der Gruppe; im Netz tragen sie deren Bezeichnung.</translation>
    </message>
    <message>
        <source>The faces and edges that the size holds for.</source>
        <translation>Die Flächen und Kanten, für die die Elementgröße gilt.</translation>
    </message>
    <message>
        <source>The group's name in the mesh; the label, unless another is given here.</source>
        <translation>Der Name der Gruppe im Netz; die Bezeichnung, wenn hier kein anderer angegeben ist.</translation>
    </message>
    <message>
        <source>The largest corner angle.</source>
        <translation>Der größte Eckenwinkel.</translation>
    </message>
    <message>
        <source>The layer that each node was extruded in; else 0.</source>
        <translation>Die Schicht, in der jeder Knoten entstand; sonst 0.</translation>
    </message>
    <message>
        <source>The local sizes of the mesh.</source>
        <translation>Die örtlichen Elementgrößen des Netzes.</translation>
    </message>
    <message>
        <source>The most that one element edge may turn along a curved edge or face; finer than size where the shape is curved.</source>
        <translation>Um wie viel sich eine Elementkante entlang einer gekrümmten Kante oder Fläche höchstens drehen darf; feiner als die Elementgröße, wo die Form gekrümmt ist.</translation>
    </message>
    <message>
        <source>The named groups of the mesh.</source>
        <translation>Die benannten Gruppen des Netzes.</translation>
    </message>
    <message>
        <source>The node, counted from 0, that each node was extruded from; else -1.</source>
        <translation>Der Knoten, von 0 gezählt, aus dem jeder Knoten entstand; sonst -1.</translation>
    </message>
    <message>
        <source>The object that is meshed.</source>
        <translation>Das Objekt, das vernetzt ist.</translation>
    </message>
    <message>
        <source>The object whose faces are meshed.</source>
        <translation>Das Objekt, dessen Flächen vernetzt werden.</translation>
    </message>
    <message>
        <source>The report of the mesh, as a job writes it.</source>
        <translation>Der Bericht über das Netz, wie ein Auftrag ihn schreibt.</translation>
    </message>
    <message>
        <source>The settings that the mesh was made with.</source>
        <translation>Die Einstellungen, mit denen das Netz erzeugt wurde.</translation>
    </message>
    <message>
        <source>The smallest corner angle.</source>
        <translation>Der kleinste Eckenwinkel.</translation>
    </message>
    <message>
        <source>The walls of the mesh.</source>
        <translation>Die Wände des Netzes.</translation>
    </message>
    <message>
        <source>The way in which the object keeps its data.</source>
        <translation>Die Art, in der das Objekt seine Daten ablegt.</translation>
    </message>
    <message>
        <source>Threads to mesh with; 0 uses all processors. The mesh does not depend on it.</source>
        <translation>Threads für die Vernetzung; 0 nutzt alle Prozessoren. Das Netz hängt nicht davon ab.</translation>
    </message>
    <message>
        <source>Triangles of the mesh.</source>
        <translation>Dreiecke des Netzes.</translation>
    </message>
    <message>
        <source>Wall: layers grow from the edges. Match: layers of other walls run along them. Off: neither.</source>
        <translation>Wall: Schichten wachsen von den Kanten. Match: Schichten anderer Wände laufen an ihnen entlang. Off: keins von beidem.</translation>
    </message>
    <message>
        <source>What fills the part that no layer reaches: quads where they come out well, or triangles.</source>
        <translation>Was den Teil füllt, den keine Schicht erreicht: Vierecke, wo sie gut werden, oder Dreiecke.</translation>
    </message>
    <message>
        <source>What the faces looked like when they were picked.</source>
        <translation>Wie die Flächen aussahen, als sie gewählt wurden.</translation>
    </message>
    <message>
        <source>What the mesher had to say.</source>
        <translation>Was der Vernetzer zu sagen hatte.</translation>
    </message>
    <message>
        <source>What the references looked like when they were picked.</source>
        <translation>Wie das Gewählte aussah, als es gewählt wurde.</translation>
    </message>
    <message>
        <source>Whether the mesh fits the settings and the shape.</source>
        <translation>Ob das Netz zu den Einstellungen und zur Form passt.</translation>
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
