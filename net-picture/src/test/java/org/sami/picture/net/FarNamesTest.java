package org.sami.picture.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.palette.Theme;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDetail;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.model.Plan;

/** What a net says of its vertices where it is too small for its words. */
class FarNamesTest {
    /** The plan without any name that its author gave. */
    private static Plan nameless(String id) {
        Plan plan = ShippedPlans.plan(id);
        return plan.withPlaces(plan.places().stream().map(p -> p.withName("")).toList())
                .withTransitions(
                        plan.transitions().stream().map(t -> t.withName("")).toList());
    }

    private static Map<String, String> names(Plan plan, NetDetail detail, double unit) {
        NetDrawing drawing =
                NetLayout.edited(plan, ShippedPlans.VOCABULARY, NetFonts::width, detail, OptionalDouble.empty());
        NetScene scene = NetScene.of(plan, drawing, NetMode.ALL, Set.of());
        Map<String, String> names = new HashMap<>();
        List<FarNames.Name> placed = FarNames.of(
                NetFigure.of(scene),
                new NetSight(drawing.bounds().grown(1000), 1 / unit, 1),
                new FramePainter(drawing.frames(), Theme.LIGHT));
        placed.forEach(name -> names.put(name.of(), String.join(" ", name.lines())));
        for (FarNames.Name one : placed) {
            assertThat(placed)
                    .noneMatch(other -> !other.equals(one) && other.box().intersects(one.box()));
            assertThat(drawing.vertices().stream()
                            .map(vertex -> vertex.box())
                            .filter((DrawingBox box) -> box.intersects(one.box())))
                    .isEmpty();
        }
        return names;
    }

    @Test
    void aVertexWithoutANameSaysItsFirstEvent() {
        Map<String, String> names = names(nameless("clv"), NetDetail.AUTHOR, 2);

        assertThat(names).containsEntry("execute", "Proxy Execute Path");
        assertThat(names.get("boats-chosen")).startsWith("Operator Selects");
    }

    @Test
    void soItDoesWhileEventsAreFolded() {
        Plan plan = nameless("clv");
        NetDrawing drawing = NetLayout.edited(
                plan,
                ShippedPlans.VOCABULARY,
                NetFonts::width,
                NetDetail.AUTHOR.withEvents(false),
                OptionalDouble.empty());

        assertThat(drawing.labels())
                .filteredOn(label -> label.of().equals("execute"))
                .singleElement()
                .satisfies(
                        label -> assertThat(label.text().lines().get(0).text()).startsWith("Proxy Execute"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"clv", "clv-interrupts", "station-keep", "measure", "panorama"})
    void eachVertexOfAPlanSaysSomethingAtHalfAndAtAThirdOfItsSize(String id) {
        Plan plan = ShippedPlans.plan(id);
        int saying = plan.places().size() + plan.transitions().size();

        assertThat(names(plan, NetDetail.AUTHOR, 2)).hasSize(saying);
        assertThat(names(plan, NetDetail.AUTHOR, 3)).hasSizeGreaterThanOrEqualTo((int) (saying * 0.9));
    }

    @Test
    void whatIsDisabledSaysSo() {
        Plan plan = ShippedPlans.plan("clv");
        Plan disabled = plan.withPlaces(
                plan.places().stream().map(p -> p.withDisabled(true)).toList());

        assertThat(names(disabled, NetDetail.AUTHOR, 2).get("execute")).isEqualTo("Execute paths (disabled)");
    }
}
