package org.sami.crw.gui.boat;

import java.util.List;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.alarm.LaunchCheck;
import org.sami.crw.operator.alarm.LaunchCheck.Item;
import org.sami.crw.operator.alarm.LaunchCheck.Subject;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRow;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/** What is to be so before the selected boat is put into the water. */
final class LaunchPanel extends JPanel {
    private final OperatorContext context;
    private final MotorTrial motor;
    private final JLabel summary = new JLabel(" ");
    private final RowTable<Item> table;

    LaunchPanel(OperatorContext context) {
        super(new MigLayout("insets 0, gap 0, fill, wrap 1", "[grow,fill]", "[][grow,fill]"));
        this.context = context;
        motor = new MotorTrial(context);
        setName("boat-launch");
        table = new RowTable<>(
                "boat-launch-table",
                context.say("Select a boat: link, position, compass, motor, battery and what it does without a link are"
                        + " gone through here."),
                Item::subject,
                List.of(
                        RowColumn.<Item>words(
                                        "Check", 150, item -> LaunchWords.mark(item.state()) + name(item.subject()))
                                .colored(item -> LaunchWords.color(item.state())),
                        RowColumn.<Item>words("How it is", 0, item -> context.say(item.text()))
                                .colored(item -> LaunchWords.color(item.state()))));
        table.table().getAccessibleContext().setAccessibleName(context.say("Boat launch"));
        summary.setName("boat-launch-summary");
        CommandRow head = new CommandRow();
        head.left(summary).right(new CommandButton(motor.command()));
        add(head);
        table.showAllRows(true); // the tab scrolls, with what stands above the checks
        add(table);
    }

    /** Shows how a boat stands now. */
    void show(Optional<BoatSnapshot> boat) {
        motor.command().refresh();
        Optional<LaunchCheck> check = boat.map(one -> LaunchCheck.of(
                one, context.models().alarms().snapshot(), motor.seenMps(one.boat()), context.nowMillis()));
        table.show(check.map(LaunchCheck::items).orElse(List.of()));
        summary.setFont(Fonts.strong());
        summary.setText(context.say(check.map(LaunchPanel::words).orElse("No boat is selected")));
        LookColors.foreground(
                summary,
                check.map(one -> one.mayLaunch() ? SemanticColor.OK : SemanticColor.WARNING)
                        .orElse(SemanticColor.MUTED));
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
            case BATTERY -> "Battery";
            case LOST_LINK -> "Without a link";
            case EQUIPMENT -> "Equipment";
        };
    }
}
