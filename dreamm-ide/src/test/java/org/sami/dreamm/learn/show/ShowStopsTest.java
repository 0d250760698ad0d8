package org.sami.dreamm.learn.show;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.lessons.script.EditScript;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Plan;

/** The pointer goes where an author's would. */
class ShowStopsTest {
    private static final Plan PLAN = new PlanBuilder("p")
            .start("a")
            .output("a", "StartSystemTimer")
            .output("a", "ProxyGotoPoint")
            .transition("t", "TimerExpired")
            .in("a", "t", InRequirement.unconditional())
            .build();

    private static List<ShowStop> stops(String element) {
        EditScript script = EditScript.read("s.json", "[" + element.replace('\'', '"') + "]")
                .orThrow();
        return ShowStops.of(script.elements().get(0), PLAN);
    }

    private static String event(int index) {
        return PLAN.places().get(0).outputs().get(index).id();
    }

    @Test
    void anEdgeIsDrawnFromVertexToVertex() {
        assertThat(stops("{'do': 'connect', 'from': 'a', 'to': 't'}"))
                .containsExactly(new ShowStop.Element("a"), new ShowStop.Element("t"));
    }

    @Test
    void aFieldIsFilledInTheCardOfItsEvent() {
        assertThat(stops("{'do': 'field', 'event': '" + event(1) + "', 'field': 'location', 'source': null}"))
                .containsExactly(
                        new ShowStop.Element("a"), new ShowStop.Editor(List.of("a"), "event-1", "field-location"));
        assertThat(stops("{'do': 'write', 'event': '" + event(0) + "', 'field': 'duration', 'variable': '@x'}"))
                .contains(new ShowStop.Editor(List.of("a"), "event-0", "field-duration-write"));
    }

    @Test
    void requirementsAreWrittenAtTheSelectedEdge() {
        String edge = PLAN.inEdges().get(0).id();
        assertThat(stops("{'do': 'require', 'edge': 'a > t', 'requirements': []}"))
                .containsExactly(new ShowStop.Element(edge), new ShowStop.Editor(List.of(edge), "", "inspector-edge"));
    }

    @Test
    void variablesAreDeclaredWhereThePlanIsShown() {
        assertThat(stops("{'do': 'variable', 'name': '@x', 'type': 'integer'}"))
                .containsExactly(new ShowStop.Editor(List.of(), "inspector-plan", "variable-x"));
    }

    @Test
    void marksOfAPlaceAreTickedInTheInspector() {
        assertThat(stops("{'do': 'end', 'what': 'a'}"))
                .containsExactly(new ShowStop.Element("a"), new ShowStop.Editor(List.of("a"), "", "inspector-end"));
    }
}
