package org.sami.crw.gui.boat;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.rows;
import static org.sami.crw.gui.SessionWorld.text;
import static org.sami.crw.gui.SessionWorld.type;

import java.awt.Component;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.BoatSnapshot.Commander;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.Stop;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** The panel of a boat over a real session: what is asked of the boat is answered by its server. */
@Tag("long")
@Timeout(900)
class SelectedBoatPanelTest {
    private static final GeoPoint FAR = GeoPoint.of(45.402, 10.9);

    @Test
    void aSettingIsInForceWhenTheBoatHasTakenItAndSaysWhyNot() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna")) {
            SelectedBoatPanel panel = panel(world, "anna");
            until(
                    panel,
                    "it says what is in force",
                    () -> text(panel, "boat-velocity-now").startsWith("in force: 1"));

            type(panel, "boat-velocity", "0.5");
            world.run("boat-set-velocity");
            until(panel, "it is taken", () -> text(panel, "boat-velocity-now").equals("in force: 0.5   ✓ taken"));

            type(panel, "boat-heading-p", "2");
            type(panel, "boat-heading-i", "much");
            type(panel, "boat-heading-d", "0.1");
            world.run("boat-set-heading");
            until(
                    panel,
                    "it is no number",
                    () -> text(panel, "boat-heading-now").contains("not 'much'"));
            type(panel, "boat-heading-i", "0");
            world.run("boat-set-heading");
            until(
                    panel,
                    "gains are taken",
                    () -> text(panel, "boat-heading-now").equals("in force: P 2, I 0, D 0.1   ✓ taken"));

            type(panel, "boat-velocity", "99");
            world.run("boat-set-velocity");
            until(panel, "it is refused", () -> text(panel, "boat-velocity-now").contains("▲ "));
        }
    }

    @Test
    void aBoatThatIsSelectedShowsItsOwnValuesAndNoAnswerOfTheOneBefore() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna", "bella")) {
            SelectedBoatPanel panel = panel(world, "anna");
            until(
                    panel,
                    "what is in force is entered",
                    () -> text(panel, "boat-velocity").equals("1"));
            type(panel, "boat-heading-p", "2");
            type(panel, "boat-velocity", "0.5");

            onEventThread(() -> {
                world.context.commands().get("boat-set-velocity").run();
                world.context.boats().select(List.of("bella")); // before anna has answered
                return null;
            });

            SessionWorld.until(
                    "anna has taken it",
                    () -> boat(world).settings().orElseThrow().velocityMultiplier() == 0.5);
            until(
                    panel,
                    "bella's is entered",
                    () -> text(panel, "boat-velocity").equals("1"));
            assertThat(text(panel, "boat-velocity-now")).isEqualTo("in force: 1");
            assertThat(text(panel, "boat-heading-p")).isNotEqualTo("2");
        }
    }

    @Test
    void aClearedBlockGivesTheBoatToOthersAndACancelledCommandFails() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna")) {
            SelectedBoatPanel panel = panel(world, "anna");
            SessionWorld.get(world.session.fleet().ask(boats -> {
                boats.find("anna").orElseThrow().commands().submit(new Stop("keep", 7, 7, Priority.LOW, true));
                return null;
            }));
            until(
                    panel,
                    "mission 7 keeps it",
                    () -> rows(panel, "boat-queue").contains("block|mission 7 keeps the boat for itself"));
            SessionWorld.get(world.session.fleet().ask(boats -> {
                boats.find("anna").orElseThrow().commands().submit(FollowPath.goTo("go", 8, 8, FAR, Priority.MEDIUM));
                return null;
            }));
            until(
                    panel,
                    "the other waits",
                    () -> rows(panel, "boat-queue")
                            .contains("1. next|go to a point, mission 8, medium|mission 7 keeps the boat"));

            world.run("boat-clear-block");
            until(
                    panel,
                    "the other is in force",
                    () -> rows(panel, "boat-queue").contains("in force|go to a point, mission 8, medium"));
            until(panel, "it is uploaded", () -> rows(panel, "boat-queue").contains("read back equal"));

            assertThat(world.whyNot("boat-cancel-command")).startsWith("select a command");
            SessionWorld.select(panel, "boat-queue", 0);
            world.run("boat-cancel-command");
            until(
                    panel,
                    "it is over",
                    () -> rows(panel, "boat-queue")
                            .contains("over|go to a point, mission 8|failed: the operator cancelled it"));
        }
    }

    @Test
    void theChecklistSaysWhatIsMissingUntilTheMotorWasTried() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna")) {
            SelectedBoatPanel panel = panel(world, "anna");
            until(
                    panel,
                    "only the motor is missing",
                    () -> text(panel, "boat-launch-summary").equals("△ not ready: 6 of 7 good"));
            assertThat(rows(panel, "boat-launch-table"))
                    .contains("? Motor|not tried")
                    .contains("✓ Without a link|holds");

            world.run("boat-try-motor");
            until(
                    panel,
                    "it may be launched",
                    () -> text(panel, "boat-launch-summary").equals("✓ may be launched: 7 of 7 good"));
            assertThat(rows(panel, "boat-launch-table")).contains("✓ Motor|");
            until(panel, "it is given back", () -> boat(world).commander() == Commander.THIS_BASE);

            SessionWorld.get(world.session.fleet().stop("anna"));
            until(
                    panel,
                    "it is stopped",
                    () -> rows(panel, "boat-launch-table").contains("▲ Motor|its motors are stopped"));
        }
    }

    @Test
    void theChecklistSetsWhatTheSessionWishesOfABoatWithoutALink() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna")) {
            SelectedBoatPanel panel = panel(world, "anna");
            SessionWorld.get(world.session.fleet().wishLostLink(Optional.of(LostLinkAction.RETURN)));
            until(
                    panel,
                    "the difference is said",
                    () -> rows(panel, "boat-launch-table")
                            .contains("△ Without a link|holds its place: set it, this session wishes that it returns to"
                                    + " its"));

            world.run("boat-set-wished-lost-link");

            until(
                    panel,
                    "it has confirmed",
                    () -> rows(panel, "boat-launch-table").contains("✓ Without a link|returns to its home"));
            assertThat(world.context
                            .commands()
                            .find("boat-set-wished-lost-link")
                            .orElseThrow()
                            .isEnabled())
                    .isFalse();
        }
    }

    @Test
    void theStickDrivesTheBoatUntilItIsGivenBack() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna")) {
            SelectedBoatPanel panel = panel(world, "anna");
            StickView stick = SessionWorld.find(panel, "boat-stick", StickView.class);
            onEventThread(() -> {
                stick.setSize(148, 148);
                mouse(stick, MouseEvent.MOUSE_PRESSED, 74, 74);
                mouse(stick, MouseEvent.MOUSE_DRAGGED, 74, 10);
                return null;
            });

            until(
                    panel,
                    "it goes by hand",
                    () -> boat(world).commander() == Commander.BY_HAND
                            && boat(world).pose().orElseThrow().speedMps() > 0.3);
            assertThat(text(panel, "boat-hand-text")).startsWith("You drive anna");

            onEventThread(() -> {
                mouse(stick, MouseEvent.MOUSE_RELEASED, 74, 10);
                return null;
            });
            world.run("boat-by-hand");
            until(panel, "it is given back", () -> boat(world).commander() == Commander.THIS_BASE);
        }
    }

    private static void mouse(Component on, int id, int x, int y) {
        on.dispatchEvent(new MouseEvent(
                on, id, System.currentTimeMillis(), InputEvent.BUTTON1_DOWN_MASK, x, y, 1, false, MouseEvent.BUTTON1));
    }

    private static BoatSnapshot boat(SessionWorld world) {
        return world.context.models().fleet().boat("anna").orElseThrow();
    }

    private static SelectedBoatPanel panel(SessionWorld world, String boat) {
        SelectedBoatPanel panel = laidOut(() -> new SelectedBoatPanel(world.context));
        onEventThread(() -> {
            world.context.boats().select(List.of(boat));
            return null;
        });
        return panel;
    }

    private static void until(SelectedBoatPanel panel, String what, BooleanSupplier condition) {
        SessionWorld.until(what, () -> {
            panel.refresh();
            return condition.getAsBoolean();
        });
    }
}
