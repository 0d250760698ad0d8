package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.find;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.text;
import static org.sami.crw.gui.SessionWorld.until;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.ui.check.Layout;
import org.sami.ui.look.Look;
import org.sami.ui.window.WindowSettings;

@Timeout(900)
class MissionEndingTest {
    @TempDir
    private Path folder;

    @Test
    void anAbortSaysWhatItDoesAndIsDoneOnlyWhenItIsConfirmed() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna", "bert")) {
            MissionMonitor monitor = monitor(world);
            long mission = world.start("clv");
            until("boats are asked for", () -> waiting(world) == 1);

            world.run("mission-abort");
            assertThat(text(monitor, "mission-ending-title")).startsWith("Abort Cooperative Location Visit");
            assertThat(text(monitor, "mission-ending-lines"))
                    .contains("No boat stops")
                    .contains("1 decision is withdrawn: ");

            world.run("mission-end-leave");
            assertThat(onEventThread(() ->
                            find(monitor, "mission-ending", EndingPanel.class).isVisible()))
                    .isFalse();
            assertThat(world.whyNot("mission-end-confirm")).isNotEmpty();
            assertThat(waiting(world)).as("nothing was done").isOne();

            send(world, mission);
            world.run("mission-abort");
            until("the boats are named", () -> {
                monitor.refresh();
                return text(monitor, "mission-ending-lines").contains("stop: nobody else wants anything of them.");
            });

            world.run("mission-end-confirm");
            until(
                    "it is aborted",
                    () -> world.context
                            .models()
                            .missions()
                            .snapshot()
                            .mission(mission)
                            .flatMap(now -> now.outcome())
                            .equals(Optional.of(Outcome.ABORTED)));
        }
    }

    @Test
    void inANarrowPanelTheNameLeadsTheLinesAndTheHeadingKeepsToOne() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna", "bert")) {
            MissionMonitor monitor = monitor(world);
            world.start("clv");
            until("boats are asked for", () -> waiting(world) == 1);
            world.run("mission-abort");

            onEventThread(() -> {
                Layout.layOut(monitor, Look.px(400), Look.px(400));
                return null;
            });

            assertThat(text(monitor, "mission-ending-title")).isEqualTo("Abort it?");
            assertThat(text(monitor, "mission-ending-lines"))
                    .startsWith("Cooperative Location Visit")
                    .contains("No boat stops");
        }
    }

    /** Answers until boats are on their way. */
    private static void send(SessionWorld world, long mission) throws Exception {
        answer(world, new Answer.Proxies(List.of("anna", "bert")));
        answer(
                world,
                new Answer.Fields(Map.of(
                        "locations", new ListValue(List.of(GeoPoint.of(45.4005, 10.9), GeoPoint.of(45.3995, 10.9))))));
        answer(world, new Answer.Option(0));
        until(
                "boats have their paths",
                () -> world.context.models().commands().snapshot().stream()
                                .filter(boat -> boat.queue()
                                        .current()
                                        .filter(entry -> entry.command().mission() == mission)
                                        .isPresent())
                                .count()
                        == 2);
    }

    private static void answer(SessionWorld world, Answer answer) throws Exception {
        until("a decision waits", () -> waiting(world) == 1);
        long decision =
                world.context.models().decisions().snapshot().get(0).decision().id();
        SessionWorld.get(world.session.answer(decision, answer, "test"));
    }

    private static int waiting(SessionWorld world) {
        return world.context.models().decisions().snapshot().size();
    }

    private MissionMonitor monitor(SessionWorld world) {
        return laidOut(() -> new MissionMonitor(
                world.context,
                new MissionStarter(
                        world.context, new WindowSettings(folder.resolve("settings")), world.editors(), values -> {}),
                world.editors(),
                new LoadedProject(Optional.empty())));
    }
}
