package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.sami.crw.operator.boat.ProxyStatus;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.TextValue;

/** What the markup Proxy Status does to the summary of the boats. */
final class StatusMarkupCases {
    private StatusMarkupCases() {}

    static void add(MarkupCatalogue catalogue) {
        catalogue.shows("ProxyStatus.status=SEVERE", "the boat is red, whatever other missions say", () -> {
            PlanScene scene = scene("SEVERE");

            scene.press("Look", "boat-1");
            scene.post(new Input.Interrupt(Ids.NONE, "Fine", List.of("boat-1", "boat-2")));
            assertThat(statuses(scene))
                    .containsExactlyInAnyOrderEntriesOf(
                            Map.of("boat-1", ProxyStatus.SEVERE, "boat-2", ProxyStatus.NOMINAL));
            assertThat(scene.world.operator.communication().snapshot().get(0).boat())
                    .isEqualTo("boat-1");
        });
        catalogue.shows("ProxyStatus.status=WARNING", "the boat is yellow until its mission ends", () -> {
            PlanScene scene = scene("WARNING");

            scene.press("Look", "boat-2");
            assertThat(statuses(scene)).containsEntry("boat-2", ProxyStatus.WARNING);
            scene.post(new Input.AbortMission(PlanScene.MISSION));
            assertThat(statuses(scene)).containsEntry("boat-2", ProxyStatus.NOMINAL);
        });
        catalogue.shows("ProxyStatus.status=NOMINAL", "the boat is green again", () -> {
            PlanScene scene = new PlanScene(marked(marked(new PlanSketch(), "Look", "SEVERE"), "Calm", "NOMINAL"), 2);

            scene.press("Look", "boat-1");
            scene.press("Calm", "boat-1");
            assertThat(statuses(scene)).containsEntry("boat-1", ProxyStatus.NOMINAL);
        });
    }

    /** Two missions; pressing Look says a status in the first, Fine in the second. */
    private static PlanScene scene(String status) {
        PlanSketch plan = marked(new PlanSketch(), "Look", status);
        marked(plan.plan("second"), "Fine", "NOMINAL");
        PlanScene scene = new PlanScene(plan, 2);
        scene.post(new Input.StartMission("second", "second", Map.of()));
        return scene;
    }

    private static PlanSketch marked(PlanSketch plan, String press, String status) {
        return plan.on("start", "OperatorInterruptReceived", "start", "generic", "interruptName", new TextValue(press))
                .marked("ProxyStatus", "status", status);
    }

    private static Map<String, ProxyStatus> statuses(PlanScene scene) {
        Map<String, ProxyStatus> statuses = new TreeMap<>();
        scene.world.operator.communication().snapshot().forEach(boat -> statuses.put(boat.boat(), boat.status()));
        return statuses;
    }
}
