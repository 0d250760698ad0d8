package org.sami.crw.gui.status;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.SessionWorld.until;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.operator.HealthModel;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.session.fault.BoatsAtFault;
import org.sami.crw.session.fault.EngineWatch;
import org.sami.palette.Theme;
import org.sami.spn.host.HostStatus;
import org.sami.spn.protocol.Priority;
import org.sami.ui.check.Layout;
import org.sami.ui.check.TextFit;
import org.sami.ui.command.Command;
import org.sami.ui.look.Look;

@Isolated("the look is one for all windows of a process")
class HealthRowTest {
    private static final HealthFault FULL = HealthFault.ofSession(
            HealthKind.JOURNAL,
            Priority.CRITICAL,
            "The journal cannot be written: the disk is full",
            "Make room on the disk");
    private static final HealthFault DRIFT = HealthFault.ofBoat(
            HealthKind.DRIFT, "anna", Priority.HIGH, "anna drifts 0.3 m/s", "Have it hold its place");

    private final List<String> shown = new ArrayList<>();
    private SessionWorld world;
    private HealthModel health;

    @BeforeEach
    void open() throws Exception {
        world = new SessionWorld(SessionWorld.library("clv"), "anna");
        health = world.context.models().health();
    }

    @AfterEach
    void close() throws Exception {
        Look.apply(Theme.LIGHT, 100);
        world.close();
    }

    private HealthRow row() throws Exception {
        HealthRow[] made = new HealthRow[1];
        SwingUtilities.invokeAndWait(() ->
                made[0] = new HealthRow(world.context, new Command("panel-health", "Health", () -> shown.add("all"))));
        return made[0];
    }

    private static String text(HealthRow row, String name) {
        return label(row, name).getText();
    }

    @Test
    void theWorstFaultStandsThereUntilItIsOver() throws Exception {
        HealthRow row = row();
        assertThat(text(row, "health-worst")).isEqualTo("● No fault");

        health.report(DRIFT);
        health.report(FULL);
        until("the worst is shown", () -> text(row, "health-worst").startsWith("▲ The journal cannot be written"));
        assertThat(text(row, "health-advice")).isEqualTo("Make room on the disk");
        assertThat(text(row, "health-others")).isEqualTo("1 more");
        assertThat(row.getAccessibleContext().getAccessibleName())
                .contains("disk is full")
                .contains("1 more");

        health.over(HealthKind.JOURNAL, "");
        until("what is left is shown", () -> text(row, "health-worst").startsWith("△ anna drifts 0.3 m/s, since"));
        health.over(HealthKind.DRIFT, "anna");
        until("nothing is wrong", () -> text(row, "health-worst").equals("● No fault"));
    }

    @Test
    void nothingMovesWhenAFaultComes() throws Exception {
        HealthRow row = row();
        int before = row.getPreferredSize().height;

        health.report(FULL);
        until("it is shown", () -> text(row, "health-worst").contains("disk"));

        assertThat(row.getPreferredSize().height).isEqualTo(before).isGreaterThanOrEqualTo(40);
    }

    @Test
    void pressingItShowsAllFaults() throws Exception {
        HealthRow row = row();

        SwingUtilities.invokeAndWait(row::doClick);

        assertThat(shown).containsExactly("all");
    }

    @Test
    void onANarrowWindowWhatToDoStandsBelowWhatIsWrong() throws Exception {
        HealthRow row = row();
        health.report(FULL);
        until("it is shown", () -> text(row, "health-worst").contains("disk"));

        SwingUtilities.invokeAndWait(() -> {
            Layout.layOut(row, 520, row.getPreferredSize().height);
            JLabel what = label(row, "health-worst");
            JLabel advice = label(row, "health-advice");
            assertRead(what, row);
            assertRead(advice, row);
            assertThat(advice.getY()).isGreaterThanOrEqualTo(what.getY() + what.getHeight());

            Layout.layOut(row, 1600, row.getPreferredSize().height);
            assertThat(advice.getX()).as("beside it, where there is room").isGreaterThan(what.getX() + what.getWidth());
        });
    }

    @Test
    void whatIsWrongWithTheJournalAndWhatToDoAreReadInASmallWindowWithLargeLetters() throws Exception {
        SwingUtilities.invokeAndWait(() -> Look.apply(Theme.LIGHT, 150));
        HealthRow row = row();
        health.report(DRIFT);
        EngineWatch watch =
                new EngineWatch(health, work -> {}, () -> null, BoatsAtFault.HOLD, reason -> {}); // no boat is there
        for (String why : List.of(
                "the disk is full",
                "another program locks it",
                "its disk does not take it",
                "it is read only, or its disk is")) {
            watch.onWaiting(new HostStatus(
                    HostStatus.Kind.WAITING,
                    "the journal cannot be written: " + why,
                    "/home/operator/.local/share/sami/sessions/2026-11-26_05-16.journal, entry 91: [SQLITE_IOERR_WRITE]"
                            + " I/O error in the VFS layer while trying to write to a file on disk"));
            until("it is shown", () -> text(row, "health-worst").contains(why));
            assertReadAt1280(row);
        }
        assertThat(row.getToolTipText().replace('\n', ' ')).contains("entry 91", "SQLITE_IOERR_WRITE");

        watch.onFailed(new HostStatus(
                HostStatus.Kind.FAILED, "the engine met an error", "at entry 91 or after: java.lang.Error: a gap"));
        until("it is shown", () -> text(row, "health-worst").contains("The engine has stopped"));
        assertReadAt1280(row);
    }

    @Test
    void whatToDoAboutEachAlarmIsReadInASmallWindowWithLargeLetters() throws Exception {
        SwingUtilities.invokeAndWait(() -> Look.apply(Theme.LIGHT, 150));
        HealthRow row = row();
        for (Alarm.Kind kind : Alarm.Kind.values()) {
            health.report(HealthFault.ofSession(
                    HealthKind.ENGINE, Priority.CRITICAL, "boat12 has the alarm " + kind, kind.advice()));
            until("it is shown", () -> text(row, "health-worst").contains(kind.name()));
            assertReadAt1280(row);
        }
    }

    private static void assertReadAt1280(HealthRow row) throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            Layout.layOut(row, 1280, row.getPreferredSize().height);
            assertRead(label(row, "health-worst"), row);
            assertRead(label(row, "health-advice"), row);
        });
    }

    private static void assertRead(JLabel label, HealthRow row) {
        assertThat(label.isVisible()).isTrue();
        assertThat(label.getWidth()).as(label.getText()).isGreaterThanOrEqualTo(label.getPreferredSize().width);
        assertThat(label.getHeight()).isGreaterThanOrEqualTo(label.getPreferredSize().height);
        assertThat(label.getX() + label.getWidth()).isLessThanOrEqualTo(row.getWidth());
        assertThat(label.getY() + label.getHeight()).isLessThanOrEqualTo(row.getHeight());
        assertThat(TextFit.faults(label)).isEmpty();
    }

    private static JLabel label(HealthRow row, String name) {
        return Layout.find(row, name, JLabel.class).orElseThrow();
    }
}
