package org.sami.crw.gui.boat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.alarm.LaunchCheck;
import org.sami.crw.operator.alarm.LaunchCheck.State;
import org.sami.crw.operator.alarm.LaunchCheck.Subject;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.gateway.LinkStatus;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRow;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/** What is to be so before the selected boat is put into the water, or the selected robot takes off. */
final class LaunchPanel extends JPanel {
    private static final long ASK_MS = 1_000; // the session may be in another place

    private final OperatorContext context;
    private final MotorTrial motor;
    private final LostLinkSetting lostLink;
    private final CommandButton setLostLink;
    private final CommandButton tryMotor;
    private final JLabel summary = new JLabel(" ");
    private final RowTable<Row> table;
    private transient List<LinkStatus> linkStatuses = List.of();
    private String statusesOf = "";
    private boolean asking;
    private long askedMs = Long.MIN_VALUE / 2;

    /** A line of the table. */
    private record Row(String title, String text, State state) {}

    LaunchPanel(OperatorContext context) {
        super(new MigLayout("insets 0, gap 0, fill, wrap 1", "[grow,fill]", "[][grow,fill]"));
        this.context = context;
        motor = new MotorTrial(context);
        lostLink = new LostLinkSetting(context);
        setLostLink = new CommandButton(lostLink.command());
        setLostLink.setVisible(false);
        tryMotor = new CommandButton(motor.command());
        setName("boat-launch");
        table = new RowTable<>(
                "boat-launch-table",
                context.say(
                        context.robots() == RobotKind.COPTER
                                ? "Select a boat: link, position, what its autopilot says, battery, what it does"
                                        + " without a link and the area are gone through here."
                                : "Select a boat: link, position, compass, motor, battery and what it does without a"
                                        + " link are gone through here."),
                Row::title,
                List.of(
                        RowColumn.<Row>words("Check", 150, row -> LaunchWords.mark(row.state()) + row.title())
                                .colored(row -> LaunchWords.color(row.state())),
                        RowColumn.<Row>words("How it is", 0, Row::text)
                                .colored(row -> LaunchWords.color(row.state()))));
        table.table().getAccessibleContext().setAccessibleName(context.say("Boat launch"));
        summary.setName("boat-launch-summary");
        CommandRow head = new CommandRow();
        head.left(summary).right(setLostLink);
        if (context.robots() != RobotKind.COPTER) {
            head.right(tryMotor);
        }
        add(head);
        table.showAllRows(true); // the tab scrolls, with what stands above the checks
        add(table);
    }

    /** Ends the trial of a motor. */
    void close() {
        motor.close();
    }

    /** Shows how a boat stands now. */
    void show(Optional<BoatSnapshot> boat) {
        motor.command().refresh();
        lostLink.command().refresh();
        setLostLink.setVisible(boat.filter(one -> LaunchCheck.isAgainstWish(one, context.lostLinkWish()))
                .isPresent());
        tryMotor.setVisible(boat.filter(one -> context.flies(one.boat())).isEmpty());
        Optional<LaunchCheck> check =
                boat.map(one -> LaunchCheck.of(one, motor.seenMps(one.boat()), context.launchFacts()));
        UnaryOperator<String> words = boat.<UnaryOperator<String>>map(one -> text -> context.sayOf(one.boat(), text))
                .orElse(context::say);
        boat.ifPresent(one -> askForLinkStatuses(one.boat()));
        table.show(rows(
                check,
                words,
                boat.filter(one -> one.boat().equals(statusesOf)).isPresent() ? linkStatuses : List.of()));
        summary.setFont(Fonts.strong());
        summary.setText(words.apply(check.map(LaunchPanel::words).orElse("No boat is selected")));
        LookColors.foreground(
                summary,
                check.map(one -> one.mayLaunch() ? SemanticColor.OK : SemanticColor.WARNING)
                        .orElse(SemanticColor.MUTED));
    }

    /** A vehicle of another maker may be reached on several links; how they are comes a moment later. */
    private void askForLinkStatuses(String boat) {
        boolean isRecent = boat.equals(statusesOf) && context.nowMillis() - askedMs < ASK_MS;
        if (asking || isRecent || context.whyNotAct().isPresent()) {
            return;
        }
        asking = true;
        askedMs = context.nowMillis();
        context.session().fleet().linkStatuses(boat).whenComplete((now, fault) -> {
            asking = false;
            if (fault == null) {
                statusesOf = boat;
                linkStatuses = now;
            }
        });
    }

    private static List<Row> rows(
            Optional<LaunchCheck> check, UnaryOperator<String> words, List<LinkStatus> linkStatuses) {
        List<Row> rows = new ArrayList<>();
        check.ifPresent(all -> all.items()
                .forEach(item -> rows.add(new Row(name(item.subject()), words.apply(item.text()), item.state()))));
        for (LinkStatus status : linkStatuses) {
            rows.add(new Row(
                    status.link().replaceFirst("^mavlink:", "Over "),
                    words.apply(status.words()),
                    status.isGood() ? State.GOOD : State.DOUBTFUL));
        }
        return rows;
    }

    private static String words(LaunchCheck check) {
        long all = check.items().size();
        return (check.mayLaunch() ? "✓ may be launched: " : "△ not ready: ") + check.good() + " of " + all + " good";
    }

    private static String name(Subject subject) {
        return switch (subject) {
            case LINK -> "Link";
            case COMMANDER -> "Command";
            case POSITION -> "Position";
            case COMPASS -> "Compass";
            case BOARD -> "Control board";
            case MOTOR -> "Motor";
            case AUTOPILOT -> "Autopilot";
            case BATTERY -> "Battery";
            case LOST_LINK -> "Without a link";
            case AREA -> "Area";
            case KIND -> "Kind";
            case EQUIPMENT -> "Equipment";
        };
    }
}
