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
    <name>AdvLayers_AcceptReferences</name>
    <message>
        <source>Accept References</source>
        <translation>Bezüge annehmen</translation>
    </message>
    <message>
        <source>Takes lost references for what their names stand for now</source>
        <translation>Nimmt verlorene Bezüge für das, wofür ihre Namen jetzt stehen</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Check</name>
    <message>
        <source>Check Mesh</source>
        <translation>Netz prüfen</translation>
    </message>
    <message>
        <source>Opens the results of the mesh: lost references, diagnostics, worst elements; a click leads to the place</source>
        <translation>Öffnet die Ergebnisse des Netzes: verlorene Bezüge, Meldungen, schlechteste Elemente; ein Klick führt zur Stelle</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourBy</name>
    <message>
        <source>Colour by</source>
        <translation>Färben nach</translation>
    </message>
    <message>
        <source>Colours the selected layer meshes, or all of the document, by one of their fields</source>
        <translation>Färbt die gewählten Schichtnetze, oder alle des Dokuments, nach einem ihrer Felder</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourByAspectRatio</name>
    <message>
        <source>Aspect Ratio</source>
        <translation>Seitenverhältnis</translation>
    </message>
    <message>
        <source>Colours the elements by their longest side over their shortest</source>
        <translation>Färbt die Elemente nach dem Verhältnis ihrer längsten zu ihrer kürzesten Seite</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourByDiagnostics</name>
    <message>
        <source>Diagnostics</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Shows the poor elements, and the places that the mesher's messages are about</source>
        <translation>Zeigt die schlechten Elemente und die Stellen, von denen die Meldungen des Vernetzers handeln</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourByHeightError</name>
    <message>
        <source>Colours the elements of layers by how far their height is from the one asked for</source>
        <translation>Färbt die Elemente der Schichten danach, wie weit ihre Höhe von der verlangten abweicht</translation>
    </message>
    <message>
        <source>Height Error</source>
        <translation>Höhenfehler</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourByLayer</name>
    <message>
        <source>Colours the elements by the layer that they belong to</source>
        <translation>Färbt die Elemente nach der Schicht, zu der sie gehören</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Schicht</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourByQuality</name>
    <message>
        <source>Colours the elements by their quality, from 0 to 1</source>
        <translation>Färbt die Elemente nach ihrer Qualität, von 0 bis 1</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
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
    <name>AdvLayers_FollowReferences</name>
    <message>
        <source>Follow References</source>
        <translation>Bezügen folgen</translation>
    </message>
    <message>
        <source>Gives lost references the names that what was picked has now, where it is still there</source>
        <translation>Gibt verlorenen Bezügen die Namen, die das Gewählte jetzt hat, wo es noch da ist</translation>
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
    <name>AdvLayers_Uncoloured</name>
    <message>
        <source>No Colours</source>
        <translation>Ohne Farben</translation>
    </message>
    <message>
        <source>Shows the elements in one colour, as FreeCAD shows a FEM mesh</source>
        <translation>Zeigt die Elemente in einer Farbe, wie FreeCAD ein FEM-Netz zeigt</translation>
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
        <source>A click shows the place</source>
        <translation>Ein Klick zeigt die Stelle</translation>
    </message>
    <message>
        <source>A named group of the selected faces and edges</source>
        <translation>Eine benannte Gruppe der gewählten Flächen und Kanten</translation>
    </message>
    <message>
        <source>A size of their own for the selected faces, edges and vertices</source>
        <translation>Eine eigene Elementgröße für die gewählten Flächen, Kanten und Punkte</translation>
    </message>
    <message>
        <source>Adds what is selected in the 3D view</source>
        <translation>Fügt hinzu, was in der 3D-Ansicht gewählt ist</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Erweitert</translation>
    </message>
    <message>
        <source>Angles from</source>
        <translation>Winkel von</translation>
    </message>
    <message>
        <source>Aspect ratio</source>
        <translation>Seitenverhältnis</translation>
    </message>
    <message>
        <source>Both ends</source>
        <translation>Beide Enden</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Cluster</source>
        <translation>Verdichtung</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Färben nach</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
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
        <source>Diagnostics</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>End height</source>
        <translation>Endhöhe</translation>
    </message>
    <message>
        <source>Ended by</source>
        <translation>Beendet durch</translation>
    </message>
    <message>
        <source>Export Mesh</source>
        <translation>Netz exportieren</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Face edges</source>
        <translation>Ränder</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Faces of {}</source>
        <translation>Flächen von {}</translation>
    </message>
    <message>
        <source>Feature angle</source>
        <translation>Kantenwinkel</translation>
    </message>
    <message>
        <source>Finishing the core</source>
        <translation>Der Kern wird vollendet</translation>
    </message>
    <message>
        <source>First height</source>
        <translation>Erste Höhe</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Wachstum</translation>
    </message>
    <message>
        <source>Height asked</source>
        <translation>Höhe verlangt</translation>
    </message>
    <message>
        <source>Height error [%]</source>
        <translation>Höhenfehler [%]</translation>
    </message>
    <message>
        <source>Height got</source>
        <translation>Höhe erreicht</translation>
    </message>
    <message>
        <source>Initial mesh</source>
        <translation>Ausgangsnetz</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Umgeklappt</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>Layer Mesh</source>
        <translation>Schichtnetz</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Layers from all edges</source>
        <translation>Schichten von allen Kanten</translation>
    </message>
    <message>
        <source>Layers grow from the selected edges; with faces selected too, on these alone</source>
        <translation>Schichten wachsen von den gewählten Kanten; sind auch Flächen gewählt, nur auf diesen</translation>
    </message>
    <message>
        <source>Layers run across the selected edges, however sharply their faces meet</source>
        <translation>Schichten laufen über die gewählten Kanten hinweg, wie scharf deren Flächen auch aneinander stoßen</translation>
    </message>
    <message>
        <source>Layers run along the selected edges</source>
        <translation>Schichten laufen an den gewählten Kanten entlang</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>Lost references</source>
        <translation>Verlorene Bezüge</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Entlang</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Vernetzen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>No layers at the selected edges</source>
        <translation>Keine Schichten an den gewählten Kanten</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Not meshed</source>
        <translation>Nicht vernetzt</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>On</source>
        <translation>An</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Veraltet</translation>
    </message>
    <message>
        <source>Patch {patch} of {patches} · layer {layer}</source>
        <translation>Teilfläche {patch} von {patches} · Schicht {layer}</translation>
    </message>
    <message>
        <source>Preview: {}</source>
        <translation>Vorschau: {}</translation>
    </message>
    <message>
        <source>Quads</source>
        <translation>Vierecke</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Refinements</source>
        <translation>Verfeinerungen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the marked row</source>
        <translation>Entfernt die markierte Zeile</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Abschnitte</translation>
    </message>
    <message>
        <source>Select faces and edges in the 3D view.</source>
        <translation>Wählen Sie Flächen und Kanten in der 3D-Ansicht.</translation>
    </message>
    <message>
        <source>Select faces or edges of the meshed shape first.</source>
        <translation>Wählen Sie zuerst Flächen oder Kanten der vernetzten Form.</translation>
    </message>
    <message>
        <source>Select faces, edges and vertices in the 3D view.</source>
        <translation>Flächen, Kanten und Punkte in der 3D-Ansicht wählen.</translation>
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
        <source>Select one shape, not several ({}): a layer mesh is of one, which may be a compound.</source>
        <translation>Wählen Sie eine einzige Form, nicht mehrere ({}): ein Schichtnetz gehört zu einer, die ein Verbund sein darf.</translation>
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
        <source>Selected: {}</source>
        <translation>Gewählt: {}</translation>
    </message>
    <message>
        <source>Selects all edges of the selected faces</source>
        <translation>Wählt alle Kanten der gewählten Flächen</translation>
    </message>
    <message>
        <source>Selects the edges that go on from the selected ones without a corner</source>
        <translation>Wählt die Kanten, die die gewählten ohne Ecke fortsetzen</translation>
    </message>
    <message>
        <source>Selects the whole loop of the selected edges; with a face selected too, that on the face</source>
        <translation>Wählt den ganzen Ring der gewählten Kanten; ist auch eine Fläche gewählt, den auf der Fläche</translation>
    </message>
    <message>
        <source>Sew tolerance</source>
        <translation>Nähtoleranz</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Elementgröße</translation>
    </message>
    <message>
        <source>Size growth</source>
        <translation>Größenwachstum</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stopped; the mesh is the one before.</source>
        <translation>Angehalten; das Netz ist das vorige.</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Wird angehalten …</translation>
    </message>
    <message>
        <source>Takes the marked rows off the list</source>
        <translation>Nimmt die markierten Zeilen von der Liste</translation>
    </message>
    <message>
        <source>Tangent</source>
        <translation>Tangential</translation>
    </message>
    <message>
        <source>The mesh is out of date: settings or model have changed.</source>
        <translation>Das Netz ist veraltet: Einstellungen oder Modell haben sich geändert.</translation>
    </message>
    <message>
        <source>The selected edges bound their faces, however smoothly these meet</source>
        <translation>Die gewählten Kanten begrenzen ihre Flächen, wie glatt diese auch aneinander stoßen</translation>
    </message>
    <message>
        <source>There is no mesh yet.</source>
        <translation>Es gibt noch kein Netz.</translation>
    </message>
    <message>
        <source>There is nothing to complain of.</source>
        <translation>Es gibt nichts zu beanstanden.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Triangulating · {seconds:.1f} s</source>
        <translation>Dreiecke werden erzeugt · {seconds:.1f} s</translation>
    </message>
    <message>
        <source>Turning angle</source>
        <translation>Drehwinkel</translation>
    </message>
    <message>
        <source>Until isotropic</source>
        <translation>Bis isotrop</translation>
    </message>
    <message>
        <source>Until they meet</source>
        <translation>Bis zum Treffen</translation>
    </message>
    <message>
        <source>Up to date</source>
        <translation>Aktuell</translation>
    </message>
    <message>
        <source>Update automatically</source>
        <translation>Automatisch aktualisieren</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>a face</source>
        <translation>eine Fläche</translation>
    </message>
    <message>
        <source>all faces</source>
        <translation>alle Flächen</translation>
    </message>
    <message>
        <source>all layers made</source>
        <translation>alle Schichten gebaut</translation>
    </message>
    <message>
        <source>all layers {} (orange)</source>
        <translation>alle Schichten {} (orange)</translation>
    </message>
    <message>
        <source>an edge</source>
        <translation>eine Kante</translation>
    </message>
    <message>
        <source>another front is too near</source>
        <translation>eine andere Front ist zu nah</translation>
    </message>
    <message>
        <source>as high as wide</source>
        <translation>so hoch wie breit</translation>
    </message>
    <message>
        <source>element {number} {where}: angles from {least:.1f}° to {largest:.1f}°</source>
        <translation>Element {number} {where}: Winkel von {least:.1f}° bis {largest:.1f}°</translation>
    </message>
    <message>
        <source>element {}: quality {:.2f}</source>
        <translation>Element {}: Güte {:.2f}</translation>
    </message>
    <message>
        <source>first height {} (blue)</source>
        <translation>erste Höhe {} (blau)</translation>
    </message>
    <message>
        <source>in layer {}</source>
        <translation>in Schicht {}</translation>
    </message>
    <message>
        <source>in layers</source>
        <translation>in Schichten</translation>
    </message>
    <message>
        <source>in the core</source>
        <translation>im Kern</translation>
    </message>
    <message>
        <source>joined with its neighbour</source>
        <translation>mit dem Nachbarn verschmolzen</translation>
    </message>
    <message>
        <source>meshed on their own, as the elements of their patches could not follow them: {}</source>
        <translation>Für sich vernetzt, weil die Elemente ihrer Teilflächen ihnen nicht folgen konnten: {}</translation>
    </message>
    <message>
        <source>meshed on their own, as they are curved more tightly than layers of this size can follow: {}</source>
        <translation>Für sich vernetzt, weil sie enger gekrümmt sind, als Schichten dieser Größe folgen können: {}</translation>
    </message>
    <message>
        <source>narrower than a tenth of the size, and their elements with them: {}</source>
        <translation>Schmaler als ein Zehntel der Größe, und ihre Elemente mit ihnen: {}</translation>
    </message>
    <message>
        <source>narrower than a tenth of the size, and their elements with them: {} and {} more</source>
        <translation>Schmaler als ein Zehntel der Größe, und ihre Elemente mit ihnen: {} und {} weitere</translation>
    </message>
    <message>
        <source>no valid element fits</source>
        <translation>kein gültiges Element passt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>pick a face or an edge of {}</source>
        <translation>wählen Sie eine Fläche oder Kante von {}</translation>
    </message>
    <message>
        <source>pick a face, an edge or a vertex of {}</source>
        <translation>wählen Sie eine Fläche, eine Kante oder einen Punkt von {}</translation>
    </message>
    <message>
        <source>quads</source>
        <translation>Vierecke</translation>
    </message>
    <message>
        <source>select faces or edges in the 3D view first</source>
        <translation>wählen Sie zuerst Flächen oder Kanten in der 3D-Ansicht</translation>
    </message>
    <message>
        <source>select in the 3D view first: {}</source>
        <translation>wählen Sie zuerst in der 3D-Ansicht: {}</translation>
    </message>
    <message>
        <source>select {} first</source>
        <translation>wählen Sie zuerst {}</translation>
    </message>
    <message>
        <source>sewing joined {} edges; free edges left: {}</source>
        <translation>Beim Nähen wurden {} Kanten verbunden; freie Kanten übrig: {}</translation>
    </message>
    <message>
        <source>shorter than a tenth of the size, and the mesh edges with them: {}</source>
        <translation>Kürzer als ein Zehntel der Größe, und die Netzkanten mit ihnen: {}</translation>
    </message>
    <message>
        <source>shorter than a tenth of the size, and the mesh edges with them: {} and {} more</source>
        <translation>Kürzer als ein Zehntel der Größe, und die Netzkanten mit ihnen: {} und {} weitere</translation>
    </message>
    <message>
        <source>the fronts have met</source>
        <translation>die Fronten sind zusammengetroffen</translation>
    </message>
    <message>
        <source>the triangulation took {} of the {} nodes of the initial mesh; the others lie on edges or too near to their neighbours</source>
        <translation>Die Triangulierung hat {} der {} Knoten des Ausgangsnetzes übernommen; die anderen liegen auf Kanten oder zu nah an ihren Nachbarn</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>{edge} on {face} has no layer</source>
        <translation>{edge} auf {face} hat keine Schicht</translation>
    </message>
    <message>
        <source>{edge} on {face}: layers end here first: {reason}</source>
        <translation>{edge} auf {face}: hier enden Schichten zuerst: {reason}</translation>
    </message>
    <message>
        <source>{edge} on {face}: the first height is most off here, by {error:+.1f} %</source>
        <translation>{edge} auf {face}: die erste Höhe weicht hier am meisten ab, um {error:+.1f} %</translation>
    </message>
    <message>
        <source>{label}: layer {layer}, {elements} elements, {seconds} s</source>
        <translation>{label}: Schicht {layer}, {elements} Elemente, {seconds} s</translation>
    </message>
    <message>
        <source>{label}: {seconds} s</source>
        <translation>{label}: {seconds} s</translation>
    </message>
    <message>
        <source>{quads} quads and {triangles} triangles ({percent:.1f} % quads) in {seconds:.1f} s</source>
        <translation>{quads} Vierecke und {triangles} Dreiecke ({percent:.1f} % Vierecke) in {seconds:.1f} s</translation>
    </message>
    <message>
        <source>{stage} · {elements} elements · {percent:.1f} % quads · {seconds:.1f} s</source>
        <translation>{stage} · {elements} Elemente · {percent:.1f} % Vierecke · {seconds:.1f} s</translation>
    </message>
    <message>
        <source>{} and {} more: first heights from {} to {} mm, off those asked for ({} mm on average) by up to {} %</source>
        <translation>{} und {} weitere: erste Höhen von {} bis {} mm; verlangt waren im Mittel {} mm, Abweichung bis zu {} %</translation>
    </message>
    <message>
        <source>{} bounds no meshed patch, and no layers grow from it; listed in boundary, it bounds its faces</source>
        <translation>{} begrenzt keine vernetzte Teilfläche, und es wachsen keine Schichten daraus; als Rand angegeben, begrenzt sie ihre Flächen</translation>
    </message>
    <message>
        <source>{} came after the mesh and does not act on it: update the mesh.</source>
        <translation>{} kam nach dem Netz und wirkt nicht darauf: aktualisieren Sie das Netz.</translation>
    </message>
    <message>
        <source>{} elements are turned over.</source>
        <translation>{} Elemente sind umgeklappt.</translation>
    </message>
    <message>
        <source>{} elements of quality {:.2f} to {:.2f}</source>
        <translation>{} Elemente mit Güte {:.2f} bis {:.2f}</translation>
    </message>
    <message>
        <source>{} has no boundary edge that layers could grow from</source>
        <translation>{} hat keine Randkante, aus der Schichten wachsen könnten</translation>
    </message>
    <message>
        <source>{} is no part of {}, which is meshed</source>
        <translation>{} ist kein Teil von {}, das vernetzt wird</translation>
    </message>
    <message>
        <source>{} is not meshed: {}</source>
        <translation>{} wird nicht vernetzt: {}</translation>
    </message>
    <message>
        <source>{} is on the list already</source>
        <translation>{} steht schon auf der Liste</translation>
    </message>
    <message>
        <source>{} meets the wall {} at {} degrees on {}: layers end there instead of running along it</source>
        <translation>{} trifft die Wand {} unter {} Grad auf {}: Schichten enden dort, statt daran entlangzulaufen</translation>
    </message>
    <message>
        <source>{} nodes of the initial mesh lay off the shape, by up to {} mm, and were put onto it</source>
        <translation>{} Knoten des Ausgangsnetzes lagen bis zu {} mm neben der Form und wurden auf sie gesetzt</translation>
    </message>
    <message>
        <source>{} on {} got first heights from {} to {} mm, off those asked for ({} mm on average) by up to {} %</source>
        <translation>{} auf {} erhielt erste Höhen von {} bis {} mm; verlangt waren im Mittel {} mm, Abweichung bis zu {} %</translation>
    </message>
    <message>
        <source>{} on {} got no layer of a height that could be measured</source>
        <translation>{} auf {} erhielt keine Schicht, deren Höhe sich messen ließe</translation>
    </message>
    <message>
        <source>{} on {} got no layers{}</source>
        <translation>{} auf {} erhielt keine Schichten{}</translation>
    </message>
    <message>
        <source>{} on {} got {} complete layers of {}{}</source>
        <translation>{} auf {} erhielt {} vollständige Schichten von {}{}</translation>
    </message>
    <message>
        <source>{} on {} got {} of {} layers</source>
        <translation>{} auf {} erhielt {} von {} Schichten</translation>
    </message>
    <message>
        <source>{}: first heights from {} to {} mm, off those asked for ({} mm on average) by up to {} %</source>
        <translation>{}: erste Höhen von {} bis {} mm; verlangt waren im Mittel {} mm, Abweichung bis zu {} %</translation>
    </message>
    <message>
        <source>{}: its elements reach over edges inside the patch; lower feature_angle to part its faces</source>
        <translation>{}: Ihre Elemente reichen über Kanten im Inneren der Teilfläche; ein kleinerer Kantenwinkel trennt die Flächen</translation>
    </message>
    <message>
        <source>{}: its layers broke the mesh: {}</source>
        <translation>{}: Die Schichten haben das Netz zerstört: {}</translation>
    </message>
    <message>
        <source>{}: its segments are fixed: layers run along it where they fit</source>
        <translation>{}: Ihre Teilung steht fest: Schichten laufen daran entlang, wo sie passen</translation>
    </message>
    <message>
        <source>{}: the layers of the faces beside it would cut it differently; its nodes follow the mean, and leave the heights asked for by up to {} %</source>
        <translation>{}: Die Schichten der Flächen daneben würden sie verschieden teilen; ihre Knoten folgen dem Mittel und weichen um bis zu {} % von den verlangten Höhen ab</translation>
    </message>
    <message>
        <source>{}: triangles more than 30 degrees off the surface: {}; the worst leans by {} degrees</source>
        <translation>{}: Dreiecke mehr als 30 Grad neben der Fläche: {}; das schlimmste neigt sich um {} Grad</translation>
    </message>
    <message>
        <source>{}: triangles turned over against the surface: {}; the worst leans by {} degrees</source>
        <translation>{}: gegen die Fläche umgeklappte Dreiecke: {}; das schlimmste neigt sich um {} Grad</translation>
    </message>
    <message>
        <source>{}: {} elements are turned over against the surface</source>
        <translation>{}: {} Elemente sind gegen die Fläche umgeklappt</translation>
    </message>
    <message>
        <source>{}: {} elements reach over edges inside the patch; lower feature_angle to part its faces</source>
        <translation>{}: {} Elemente reichen über Kanten im Inneren der Teilfläche; ein kleinerer Kantenwinkel trennt die Flächen</translation>
    </message>
</context>
<context>
    <name>App::Property</name>
    <message>
        <source>An existing mesh of the shape to start from. Inside the faces its nodes are where the triangulation starts; where it is finer than size, edges and core become as fine. Its layers and its order do not come over.</source>
        <translation>Ein vorhandenes Netz der Form, mit dem begonnen wird. Im Inneren der Flächen sind seine Knoten der Anfang der Triangulierung; wo es feiner ist als die Größe, werden Kanten und Kern ebenso fein. Seine Schichten und seine Ordnung werden nicht übernommen.</translation>
    </message>
    <message>
        <source>Clusters towards both ends: the ratio is then that of the middle to the ends.</source>
        <translation>Verdichtet zu beiden Enden hin: das Verhältnis ist dann das der Mitte zu den Enden.</translation>
    </message>
    <message>
        <source>Corner angles from 45 to 135 degrees [%].</source>
        <translation>Eckenwinkel von 45 bis 135 Grad [%].</translation>
    </message>
    <message>
        <source>Counts and nodes of the initial mesh that the mesh was made from.</source>
        <translation>Anzahlen und Knoten des Ausgangsnetzes, aus dem das Netz entstand.</translation>
    </message>
    <message>
        <source>Each layer is this much higher than the one before it.</source>
        <translation>Jede Schicht ist um diesen Faktor höher als die vorige.</translation>
    </message>
    <message>
        <source>Each layer of this wall is this much higher than the one before it. 0: not given.</source>
        <translation>Jede Schicht dieser Wand ist um diesen Faktor höher als die vorige. 0: nicht angegeben.</translation>
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
        <source>Faces whose edges lie within this distance of each other are joined there before meshing; 0 joins none. Faces and edges keep their names.</source>
        <translation>Flächen, deren Kanten nicht weiter als dies voneinander liegen, werden dort vor dem Vernetzen verbunden; 0 verbindet keine. Flächen und Kanten behalten ihre Namen.</translation>
    </message>
    <message>
        <source>Height of all layers together. With two of first_height, growth and layers it gives the third; where fewer are given, the job's stand in, and layers are worked out first. 0: not given.</source>
        <translation>Höhe aller Schichten zusammen. Mit zweien von first_height, growth und layers ergibt sie das dritte; sind weniger angegeben, treten die des Auftrags ein, und layers wird zuerst berechnet. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Height of the first layer, measured along the surface. Default: 1/10 of size.</source>
        <translation>Höhe der ersten Schicht, entlang der Oberfläche gemessen. Vorgabe: 1/10 der Elementgröße.</translation>
    </message>
    <message>
        <source>Height of this wall's first layer. 0: not given.</source>
        <translation>Höhe der ersten Schicht dieser Wand. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>How far the height of each element of a layer is from the one asked for, relative to it; NaN for the core.</source>
        <translation>Wie weit die Höhe jedes Elements einer Schicht von der verlangten abweicht, bezogen auf diese; NaN für den Kern.</translation>
    </message>
    <message>
        <source>Instead of first_height: the angle that the wall turns over a length of one first height; the height is size where the wall is straight. 0: not given.</source>
        <translation>Statt first_height: der Winkel, um den sich die Wand über die Länge einer ersten Höhe dreht; wo die Wand gerade ist, ist die Höhe die Elementgröße. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Instead of first_height: the length of the mesh edges along the wall over the first height, everywhere. 0: not given.</source>
        <translation>Statt first_height: die Länge der Netzkanten entlang der Wand durch die erste Höhe, überall. 0: nicht angegeben.</translation>
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
        <source>Number of this wall's layers; 0 grows them until the fronts close. -1: not given.</source>
        <translation>Zahl der Schichten dieser Wand; bei 0 wachsen sie, bis die Fronten sich schließen. -1: nicht angegeben.</translation>
    </message>
    <message>
        <source>Points about which the mesh is finer; as a property, texts of five numbers: x y z size radius.</source>
        <translation>Punkte, um die das Netz feiner ist; als Eigenschaft Texte aus fünf Zahlen: x y z Größe Radius.</translation>
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
        <source>Ratio of the last mesh edge along a CAD edge to the first, in geometric steps. 0: not given.</source>
        <translation>Verhältnis der letzten Netzkante entlang einer CAD-Kante zur ersten, in geometrischen Schritten. 0: nicht angegeben.</translation>
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
        <source>The faces, edges and vertices that the size holds for.</source>
        <translation>Die Flächen, Kanten und Eckpunkte, für die die Elementgröße gilt.</translation>
    </message>
    <message>
        <source>The first height at the end of each edge; it changes linearly along the edge, from first_height at its first vertex. 0: not given.</source>
        <translation>Die erste Höhe am Ende jeder Kante; sie ändert sich linear entlang der Kante, ausgehend von first_height am ersten Eckpunkt. 0: nicht angegeben.</translation>
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
        <source>The most that neighbouring mesh edges differ in length where the size changes, through the surface and along edges.</source>
        <translation>Der Faktor, um den sich benachbarte Netzkanten höchstens in der Länge unterscheiden, wo die Größe wechselt, in der Fläche und entlang von Kanten.</translation>
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
        <source>The size holds within this distance of the point.</source>
        <translation>Die Elementgröße gilt bis zu diesem Abstand vom Punkt.</translation>
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
        <source>Wall: layers grow from the edges. Match: layers of other walls run along them. Off: neither. Boundary: they bound their faces, however smoothly these meet. Smooth: layers run across them.</source>
        <translation>Wall: Schichten wachsen von den Kanten. Match: Schichten anderer Wände laufen an ihnen entlang. Off: keins von beidem. Boundary: sie begrenzen ihre Flächen, wie glatt diese auch aneinander stoßen. Smooth: Schichten laufen über sie hinweg.</translation>
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
