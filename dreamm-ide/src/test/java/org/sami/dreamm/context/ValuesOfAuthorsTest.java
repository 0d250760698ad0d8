package org.sami.dreamm.context;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.sami.dreamm.OnEventThread;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.spn.edit.VariableEdit;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.ui.check.Layout;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.map.MapView;
import org.sami.ui.value.ValueEditor;
import org.sami.ui.value.ValueField;

/** Values as an author gives them: names of robots that nobody has met yet, and maps that open where the project's water is. */
@ExtendWith(OnEventThread.class)
class ValuesOfAuthorsTest {
    private static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final ValueType POINT_PER_BOAT = new ValueType.MapOf(ValueType.Simple.PROXY, ValueType.Simple.POINT);
    private static final GeoPoint KATARA = new GeoPoint(25.36, 51.53, 0);

    private DreammContext context;

    @BeforeEach
    void openAPlan() {
        context = new DreammContext(
                BOATS,
                new ProjectDocument(
                        BOATS.vocabulary(), BOATS.projectOf("station-keep").orElseThrow(), Optional.empty()),
                Profile.ALL);
    }

    @AfterEach
    void close() {
        context.close();
    }

    private void declare(String name, ValueType type, Value first) {
        context.apply(new VariableEdit.AddVariable(Optional.empty(), new VariableSpec(name, type, Optional.of(first))));
    }

    private ValueEditor editor(ValueType type) {
        return context.values().editor(new ValueField("points", "Points", type, "", ""));
    }

    private static <C extends JComponent> C find(ValueEditor editor, String name, Class<C> type) {
        return Layout.find(editor.component(), name, type).orElseThrow(() -> new AssertionError("there is no " + name));
    }

    private static JComboBox<?> name(ValueEditor editor, int entry) {
        return find(editor, "value-points-" + entry + "-key-name", JComboBox.class);
    }

    private static void type(JComboBox<?> name, String words) {
        ((JTextComponent) name.getEditor().getEditorComponent()).setText(words);
    }

    @Test
    void entryOfAMapPerBoatIsGivenForANameThatIsTyped() {
        ValueEditor editor = editor(POINT_PER_BOAT);

        find(editor, "value-points-add", AbstractButton.class).doClick();
        assertThat(editor.entry().reason())
                .hasValueSatisfying(why -> assertThat(why).contains("name"));
        type(name(editor, 1), " amber ");
        find(editor, "value-points-1-value-text", JTextComponent.class).setText("25.36, 51.53");

        assertThat(editor.entry().value()).contains(new MapValue(Map.of(new ProxyValue("amber"), KATARA)));
        assertThat(editor.isTouched()).isTrue();
    }

    @Test
    void namesOfTheDeploymentAreOffered() {
        declare(
                "@boats",
                new ValueType.ListOf(new ValueType.Named("BoatId")),
                new ListValue(List.of(boat("amber"), boat("blue"))));
        ValueEditor editor = editor(POINT_PER_BOAT);
        find(editor, "value-points-add", AbstractButton.class).doClick();

        JComboBox<?> names = name(editor, 1);

        assertThat(names.getItemAt(0)).isEqualTo("amber");
        assertThat(names.getItemAt(1)).isEqualTo("blue");
        names.setSelectedItem("blue");
        find(editor, "value-points-1-value-text", JTextComponent.class).setText("25.36, 51.53");
        assertThat(editor.entry().value()).contains(new MapValue(Map.of(new ProxyValue("blue"), KATARA)));
    }

    private static RecordValue boat(String name) {
        return new RecordValue(
                "BoatId",
                Map.of(
                        "name", new TextValue(name),
                        "color", new TextValue("#e69f00"),
                        "server", new TextValue("192.168.1.101:11411"),
                        "imageStorageDirectory", new TextValue("")));
    }

    @Test
    void givenMapIsShownAndListsOfBoatsAreTypedToo() {
        ValueEditor editor = editor(POINT_PER_BOAT);
        MapValue value = new MapValue(Map.of(new ProxyValue("amber"), KATARA));

        editor.show(value);

        assertThat(editor.entry().value()).contains(value);
        assertThat(name(editor, 1).getEditor().getItem()).isEqualTo("amber");
        ValueEditor list = editor(new ValueType.ListOf(ValueType.Simple.PROXY));
        list.show(new ListValue(List.of(new ProxyValue("amber"), new ProxyValue("blue"))));
        assertThat(list.entry().value())
                .contains(new ListValue(List.of(new ProxyValue("amber"), new ProxyValue("blue"))));
    }

    private MapView map() {
        ValueEditor editor = editor(ValueType.Simple.POINT);
        editor.component().setSize(new Dimension(400, 500));
        Layout.layOut(editor.component(), 400, 500);
        return find(editor, "value-points-map", MapView.class);
    }

    @Test
    void mapOpensAtTheProjectsWaterWithItsAreas() {
        GeoArea water = new GeoArea(
                List.of(
                        new GeoPoint(25.3572, 51.5262, 0),
                        new GeoPoint(25.3572, 51.533, 0),
                        new GeoPoint(25.3622, 51.533, 0),
                        new GeoPoint(25.3622, 51.5262, 0)),
                List.of());
        declare("@water", ValueType.Simple.AREA, water);

        MapView map = map();

        assertThat(water.outline()).allMatch(map.frame()::isShown);
        assertThat(map.frame().metresPerPixel()).isLessThan(20);
        assertThat(map.layers().all()).extracting(l -> l.id()).contains("project-areas");
    }

    @Test
    void mapIsMadeHigherAndTheNextOneIsAsHigh() {
        ValueEditor editor = editor(ValueType.Simple.POINT);
        Layout.layOut(editor.component(), 400, 900);
        JComponent grip = find(editor, "value-points-map-height", JComponent.class);

        for (int i = 0; i < 5; i++) {
            grip.getActionMap().get("DOWN").actionPerformed(null);
            Layout.layOut(editor.component(), 400, 900);
        }

        assertThat(editor(ValueType.Simple.POINT).component().getPreferredSize().height)
                .isGreaterThan(240 + 4 * 40);
    }

    @Test
    void mapOfAProjectWithoutPlacesOpensWhereTheLastOneWas() {
        MapView first = map();
        first.fit(GeoBounds.of(List.of(KATARA, new GeoPoint(25.37, 51.54, 0))).orElseThrow());

        MapView second = map();

        assertThat(second.frame().isShown(KATARA)).isTrue();
        assertThat(second.frame().metresPerPixel()).isLessThan(50);
    }
}
