package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.sami.crw.handler.EventCatalogue.Seen;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;

/** What boats report by themselves, and what is reported to the operator. */
final class NewsEventCases {
    private NewsEventCases() {}

    static void add(EventCatalogue catalogue) {
        catalogue
                .shows(
                        "DisplayMessage",
                        Seen.IN_A_REPORT,
                        "the message is in the operator's list",
                        NewsEventCases::message)
                .shows(
                        "ProxyCreated",
                        Seen.IN_THE_MARKING,
                        "a boat that connects while the mission runs joins it",
                        NewsEventCases::created)
                .shows(
                        "ProxyConnected",
                        Seen.IN_THE_MARKING,
                        "the boat that the mission asked for joins it, another boat that connects does not",
                        NewsEventCases::connected)
                .shows(
                        "ProxyPoseUpdated",
                        Seen.IN_THE_MARKING,
                        "a boat moves on at its next report of where it is",
                        () -> new PlanScene(new PlanSketch().on("here", "ProxyPoseUpdated", "heard"), 1)
                                .untilBoat("boat-1", "heard"))
                .shows(
                        "BatteryNominal",
                        Seen.IN_THE_MARKING,
                        "a boat whose battery was changed for a full one moves on",
                        () -> battery(5, 100, "BatteryNominal"))
                .shows(
                        "BatteryLow",
                        Seen.IN_THE_MARKING,
                        "a boat whose battery is getting low moves on, with the charge in the variable",
                        () -> battery(100, 15, "BatteryLow"))
                .shows(
                        "BatteryCritical",
                        Seen.IN_THE_MARKING,
                        "a boat whose battery is nearly empty moves on, with the charge in the variable",
                        () -> battery(100, 2, "BatteryCritical"))
                .shows(
                        "BatteryLevelSubscription",
                        Seen.IN_THE_MARKING,
                        "a boat moves on by the subscription's thresholds, not by its own",
                        NewsEventCases::subscription)
                .shows(
                        "ProxyTakenOver",
                        Seen.IN_THE_MARKING,
                        "the boat that a person drives moves on, with who has it in the variable",
                        () -> assertThat(takenOver().stands(PlanScene.boat("boat-2"), "going"))
                                .isTrue())
                .shows(
                        "ProxyReleased",
                        Seen.ON_A_BOAT,
                        "the boat that the person gives back moves on, and drives to where it was sent",
                        NewsEventCases::released);
    }

    private static void subscription() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks(
                                "here",
                                "BatteryLevelSubscription",
                                "low",
                                new RealValue(60),
                                "critical",
                                new RealValue(40))
                        .on("here", "BatteryLow", "low"),
                1);
        scene.run(2);
        assertThat(scene.stands(PlanScene.boat("boat-1"), "here")).isTrue();
        scene.world.hull("boat-1").setBatteryPercent(50);
        scene.untilBoat("boat-1", "low");
    }

    /** Two boats go somewhere; a person takes the first. */
    private static PlanScene takenOver() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .variable("@by", "text")
                        .asks("going", "ProxyGotoLatLon", "location", PlanScene.at(0, 60))
                        .on("going", "ProxyTakenOver", "by hand")
                        .writing("by", "@by")
                        .on("by hand", "ProxyReleased", "free"),
                2);
        scene.run(5);
        scene.world.boats.find("boat-1").orElseThrow().teleoperate(1, 0.5);
        scene.untilBoat("boat-1", "by hand");
        assertThat(((TextValue) scene.variable("@by")).value()).isEqualTo("operator");
        return scene;
    }

    private static void released() {
        PlanScene scene = takenOver();
        BoatProxy boat = scene.world.boats.find("boat-1").orElseThrow();
        scene.run(5);
        assertThat(scene.stands(PlanScene.boat("boat-1"), "by hand")).isTrue();
        boat.release();
        scene.untilBoat("boat-1", "free");
        scene.until(
                "it arrives", () -> Geodesy.distanceM(scene.world.hull("boat-1").position(), PlanScene.at(0, 60)) < 4);
    }

    private static void message() {
        PlanScene scene = new PlanScene(
                new PlanSketch().asks("here", "DisplayMessage", "message", new TextValue("All is well")), 1);
        scene.run(1);
        assertThat(scene.messages()).contains("All is well");
    }

    private static void created() {
        PlanScene scene = new PlanScene(new PlanSketch().joining("here", "ProxyCreated", "team"), 1);
        scene.world.addBoat("late", 20, 0);
        scene.untilBoat("late", "team");
        assertThat(scene.used("ProxyCreated").get(0).proxies()).isEqualTo(List.of("late"));
    }

    private static void connected() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks(
                                "ask",
                                "ConnectExistingProxy",
                                "name",
                                new TextValue("red"),
                                "server",
                                new TextValue("10.0.0.1:11411"))
                        .joining("ask", "ProxyConnected", "team"),
                0);
        scene.world.addBoat("late", 20, 0);
        scene.untilBoat("red at 10.0.0.1:11411", "team");
        assertThat(scene.stands(PlanScene.boat("late"), "team")).isFalse();
    }

    private static void battery(double before, double after, String news) {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .variable("@percent", "real")
                        .on("here", news, "heard")
                        .writing("percent", "@percent"),
                1,
                percent -> percent.setBatteryPercent(before));
        assertThat(scene.stands(PlanScene.boat("boat-1"), "here")).isTrue();
        scene.world.hull("boat-1").setBatteryPercent(after);
        scene.untilBoat("boat-1", "heard");
        assertThat(((RealValue) scene.variable("@percent")).value()).isEqualTo(after);
    }
}
