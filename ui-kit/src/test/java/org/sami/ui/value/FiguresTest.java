package org.sami.ui.value;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

class FiguresTest {
    private static final GeoPath NOWHERE = new GeoPath(List.of());

    private static List<String> lines(List<? extends Value> keys) {
        Map<Value, Value> entries = new LinkedHashMap<>();
        keys.forEach(key -> entries.put(key, NOWHERE));
        return List.copyOf(Figures.of(new MapValue(entries)).lines().keySet());
    }

    @Test
    void robotsStandByTheirNamesAndAllElseInTheOrderOfTheMap() {
        assertThat(lines(List.of(new ProxyValue("bert"), new ProxyValue("carl"), new ProxyValue("anna"))))
                .containsExactly("anna", "bert", "carl");
        assertThat(lines(List.of(new TextValue("second"), new TextValue("first"))))
                .containsExactly("second", "first");
    }

    @Test
    void theLengthOfAPathIsThatOfTheWayFromWhereItsRobotIs() {
        GeoPath path = new GeoPath(List.of(GeoPoint.of(45, 10), GeoPoint.of(45, 10.01)));
        MapValue solution = new MapValue(Map.of(new ProxyValue("anna"), path, new ProxyValue("bert"), path));
        List<GeoPoint> way = List.of(GeoPoint.of(45.01, 10), GeoPoint.of(45, 10), GeoPoint.of(45, 10.01));

        Figures figures = Figures.of(solution, Map.of(new RobotPath("anna", path), way));

        assertThat(figures.lines())
                .containsEntry("anna", "2 points, 1.90 km from where it is")
                .containsEntry("bert", "2 points, 788 m from the first on");
    }

    @Test
    void anOptionSaysTheWholeWayAsSoonAsItIsKnown() throws Exception {
        GeoPath path = new GeoPath(List.of(GeoPoint.of(45, 10), GeoPoint.of(45, 10.01)));
        MapValue solution = new MapValue(Map.of(new ProxyValue("anna"), path));
        List<Consumer<List<GeoPoint>>> asked = new ArrayList<>();
        SwingUtilities.invokeAndWait(() -> {
            JPanel panel = new JPanel();
            SolutionLines.add(panel, solution, (robot, asking, found) -> asked.add(found));
            WrappedText text = (WrappedText) panel.getComponent(1);
            assertThat(text.getText()).isEqualTo("2 points, 788 m from the first on");

            asked.get(0).accept(List.of(GeoPoint.of(45.01, 10), GeoPoint.of(45, 10), GeoPoint.of(45, 10.01)));
            assertThat(text.getText()).isEqualTo("2 points, 1.90 km from where it is");

            asked.get(0)
                    .accept(List.of(
                            GeoPoint.of(45.01, 10),
                            GeoPoint.of(45.01, 9.99),
                            GeoPoint.of(45, 10),
                            GeoPoint.of(45, 10.01)));
            assertThat(text.getText())
                    .as("around what is to be avoided")
                    .isEqualTo("2 points, 2.94 km from where it is");
        });
    }
}
