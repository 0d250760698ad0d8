package org.sami.crw.operator.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.model.Project;

class PlanTreeTest {
    private static final Project LAKE = project("""
        [{"label": "Boats", "children": [{"plan": "connect"}]},
         {"label": "Explorations", "children": [{"plan": "team", "children": [{"plan": "swap"}]}]}]\
        """);

    private static Project project(String tree) {
        return new ProjectReader(
                        VocabularyReader.fromClassPath("/org/sami/domain/crw").orThrow())
                .read("""
                    {"formatVersion": 1, "id": "lake", "name": "Lake", "domain": "crw", "missionTree": %s, "plans": [
                      {"id": "swap", "name": "Swap battery", "description": "To the quay and back",
                       "places": [{"id": "p", "start": true}], "transitions": [], "inEdges": [], "outEdges": []},
                      {"id": "team", "name": "Explore Area", "description": "Each boat explores its share",
                       "places": [{"id": "p", "start": true}], "transitions": [], "inEdges": [], "outEdges": []},
                      {"id": "connect", "name": "Connect Boat",
                       "places": [{"id": "p", "start": true}], "transitions": [], "inEdges": [], "outEdges": []},
                      {"id": "spare", "name": "Spare",
                       "places": [{"id": "p", "start": true}], "transitions": [], "inEdges": [], "outEdges": []}]}
                    """.formatted(tree))
                .orThrow();
    }

    private static List<String> shown(List<PlanTree.Line> lines) {
        return lines.stream()
                .map(line -> "  ".repeat(line.depth()) + (line.plan().isEmpty() ? line.title() + "/" : line.title()))
                .toList();
    }

    @Test
    void plansStandInTheMissionTreeAndThoseOutsideOfItFollow() {
        assertThat(shown(PlanTree.of(LAKE)))
                .containsExactly(
                        "Boats/",
                        "  Connect Boat",
                        "Explorations/",
                        "  Explore Area",
                        "    Swap battery",
                        "Other plans/",
                        "  Spare");
        assertThat(shown(PlanTree.of(project("[]"))))
                .containsExactly("Swap battery", "Explore Area", "Connect Boat", "Spare");
    }

    @Test
    void aSearchFindsTitlesIdsAndDescriptionsBelowWhatTheyStandIn() {
        assertThat(shown(PlanTree.of(LAKE, "QUAY swap")))
                .containsExactly("Explorations/", "  Explore Area", "    Swap battery");
        assertThat(shown(PlanTree.of(LAKE, " connect "))).containsExactly("Boats/", "  Connect Boat");
        assertThat(PlanTree.of(LAKE, "submarine")).isEmpty();
    }

    @Test
    void aLineKeepsItsNumberInEverySearch() {
        PlanTree.Line all = PlanTree.of(LAKE).get(4);

        assertThat(PlanTree.of(LAKE, "swap")).contains(all);
    }
}
