package org.sami.crw.gui.notice;

import java.awt.BorderLayout;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import org.sami.crw.gui.boat.BoatNameColumn;
import org.sami.crw.gui.boat.BoatWords;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.boat.BoatCommunication;
import org.sami.crw.operator.boat.BoatCommunication.InMission;
import org.sami.crw.operator.boat.FleetCount;
import org.sami.crw.operator.boat.ProxyStatus;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.operator.mission.MissionsSnapshot;
import org.sami.crw.proxy.status.LinkState;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;
import org.sami.ui.replay.SessionClock;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/**
 * The Communication Frame (thesis 5.2.1, 6.3.4): how each boat stands in the missions, the worst first, and its link next to it. A boat is red
 * where it is severe in any mission, yellow where it is a warning in any, else green; a word and a shape say the same.
 */
public final class CommunicationPanel extends JPanel {
    private final OperatorContext context;
    private final JLabel summary = new JLabel();
    private final RowTable<Shown> table;

    /** A boat as it is shown; the age of its link changes by itself. */
    private record Shown(BoatCommunication boat, String said, String link, SemanticColor linkColor) {
        String name() {
            return boat.boat();
        }
    }

    /** The boats of the session. */
    public CommunicationPanel(OperatorContext context) {
        super(new BorderLayout());
        this.context = context;
        table = new RowTable<>(
                "communication-table",
                context.say("No boat is known. Each stands here as missions see it, such as Monitor Communications, and"
                        + " with its link."),
                Shown::name,
                List.of(
                        BoatNameColumn.names(context, Shown::name),
                        RowColumn.<Shown>words(
                                        "Status",
                                        112,
                                        shown -> words(shown.boat().status()))
                                .colored(shown -> color(shown.boat().status())),
                        RowColumn.<Shown>number("Link", 104, Shown::link).colored(Shown::linkColor),
                        RowColumn.<Shown>words("In missions", 0, Shown::said).asSpare()));
        BoatNameColumn.shareSelection(context, table, Shown::name);
        summary.setName("communication-summary");
        int inset = Look.px(Spacing.NORMAL);
        summary.setBorder(BorderFactory.createEmptyBorder(inset, inset, inset, inset));
        add(summary, BorderLayout.NORTH);
        add(table);
        refresh();
    }

    /** Shows how they stand now; to be called a few times a second, as ages change by themselves. */
    public void refresh() {
        List<BoatCommunication> boats = context.models().communication().snapshot();
        MissionsSnapshot missions = context.models().missions().snapshot();
        long now = context.nowMillis();
        table.show(boats.stream().map(boat -> shown(boat, missions, now)).toList());
        FleetCount count = FleetCount.of(
                context.models().fleet().snapshot(),
                context.models().unreached().snapshot());
        summary.setText(context.say(summary(boats, count)));
        summary.setToolTipText(summary.getText());
        LookColors.foreground(
                summary,
                color(boats.isEmpty() ? ProxyStatus.NOMINAL : boats.get(0).status()));
        summary.setVisible(!boats.isEmpty());
    }

    private static Shown shown(BoatCommunication boat, MissionsSnapshot missions, long now) {
        boolean lost = boat.link() == LinkState.LOST;
        boolean stale =
                boat.heardAtMillis().isPresent() && now - boat.heardAtMillis().getAsLong() > BoatWords.STALE_MS;
        return new Shown(
                boat,
                boat.missions().stream().map(one -> said(one, missions)).collect(Collectors.joining("  ·  ")),
                BoatWords.link(boat.link(), boat.heardAtMillis(), now),
                lost || stale
                        ? SemanticColor.CRITICAL
                        : boat.heardAtMillis().isEmpty() ? SemanticColor.MUTED : SemanticColor.TEXT);
    }

    private static String said(InMission one, MissionsSnapshot missions) {
        String title =
                missions.mission(one.mission()).map(MissionSnapshot::title).orElse("mission");
        return title + " (" + one.mission() + "): " + word(one.status()) + " since "
                + SessionClock.text(one.sinceMillis());
    }

    /** How many boats there are of each status: what a look from afar is to find. */
    static String summary(List<BoatCommunication> boats, FleetCount count) {
        long severe = count(boats, ProxyStatus.SEVERE);
        long warning = count(boats, ProxyStatus.WARNING);
        String mark = severe > 0 ? "▲ " : warning > 0 ? "△ " : "● ";
        return mark + severe + " severe  ·  " + warning + " warning  ·  " + count(boats, ProxyStatus.NOMINAL)
                + " nominal  ·  " + count.words() + (count.lost() == 0 ? "" : "  ·  " + count.lostWords());
    }

    private static long count(List<BoatCommunication> boats, ProxyStatus status) {
        return boats.stream().filter(boat -> boat.status() == status).count();
    }

    private static String words(ProxyStatus status) {
        return switch (status) {
                    case NOMINAL -> "● ";
                    case WARNING -> "△ ";
                    case SEVERE -> "▲ ";
                }
                + word(status);
    }

    private static String word(ProxyStatus status) {
        return switch (status) {
            case NOMINAL -> "nominal";
            case WARNING -> "warning";
            case SEVERE -> "severe";
        };
    }

    private static SemanticColor color(ProxyStatus status) {
        return switch (status) {
            case NOMINAL -> SemanticColor.OK;
            case WARNING -> SemanticColor.WARNING;
            case SEVERE -> SemanticColor.CRITICAL;
        };
    }
}
