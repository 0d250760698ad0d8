package org.sami.crw.gui.status;

import java.awt.Dimension;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.health.Health;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.palette.SemanticColor;
import org.sami.spn.protocol.Priority;
import org.sami.ui.command.Command;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.replay.SessionClock;
import org.sami.ui.table.TooltipLines;

/**
 * The row below the strip: the worst fault that lasts, since when, what to do, and how many there are besides. The remedy is next to the fault, or below
 * it where one line has no room for both. The row is always there and equally high, so that nothing moves when a fault comes or goes; pressing it shows all
 * faults with their details. On the event thread.
 */
public final class HealthRow extends JButton {
    private static final int LEAST_HEIGHT = 40;
    private static final int INSET = 12;
    private static final int GAP = 16;

    private final transient OperatorContext context;
    private final transient Command showHealth;
    private final JLabel what = new JLabel();
    private final JLabel advice = new JLabel();
    private final JLabel others = new JLabel();

    /**
     * The row of a window.
     *
     * @param showHealth brings the panel with all faults to the front
     */
    public HealthRow(OperatorContext context, Command showHealth) {
        this.context = context;
        this.showHealth = showHealth;
        setLayout(null);
        setName("health-row");
        setFocusable(false);
        what.setName("health-worst");
        advice.setName("health-advice");
        others.setName("health-others");
        add(what);
        add(advice);
        add(others);
        addActionListener(showHealth);
        style();
        context.models().health().addListener(this::show);
        show(context.models().health().snapshot());
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (what != null) {
            style();
        }
    }

    @Override
    public void doLayout() {
        int left = Look.px(INSET);
        int besides = others.getPreferredSize().width;
        int right = getWidth() - left - besides;
        put(others, right, 0, besides, getHeight());
        int room = Math.max(0, right - left - (besides > 0 ? Look.px(GAP) : 0));
        int first = what.getPreferredSize().width;
        int second = advice.getPreferredSize().width;
        if (second == 0 || first + Look.px(GAP) + second <= room) {
            put(what, left, 0, first, getHeight());
            put(advice, left + first + Look.px(GAP), 0, second, getHeight());
        } else {
            int line = line();
            int top = (getHeight() - 2 * line) / 2;
            put(what, left, top, Math.min(first, room), line);
            put(advice, left, top + line, Math.min(second, room), line);
        }
    }

    private static void put(JLabel label, int x, int y, int width, int height) {
        label.setBounds(x, y, Math.max(0, width), height);
    }

    private int line() {
        return what.getFontMetrics(what.getFont()).getHeight();
    }

    /** As high without a fault as with one, of which what to do stands below it. */
    @Override
    public Dimension getPreferredSize() {
        return new Dimension(0, Math.max(Look.px(LEAST_HEIGHT), 2 * line() + Look.px(4)));
    }

    @Override
    public Dimension getMinimumSize() {
        return getPreferredSize();
    }

    private void style() {
        setBorder(BorderFactory.createEmptyBorder());
        setBorderPainted(false);
        what.setFont(Fonts.strong());
        advice.setFont(Fonts.text());
        others.setFont(Fonts.strong());
    }

    private void show(Health health) {
        Optional<HealthEntry> worst = health.worst();
        what.setText(worst.map(HealthRow::words).orElse("● No fault"));
        advice.setText(worst.map(entry -> entry.fault().advice()).orElse(""));
        int besides = health.entries().size() - 1;
        others.setText(besides > 0 ? besides + " more" : "");
        revalidate();
        colour(worst.map(HealthEntry::severity));
        String all = worst.map(entry -> words(entry) + ". " + entry.fault().advice() + details(entry))
                        .orElse(context.say("No fault of engine, journal, missions, boats or links"))
                + (besides > 0 ? ". " + others.getText() : "");
        getAccessibleContext().setAccessibleName(all);
        setToolTipText(TooltipLines.of(all + " – show all (" + showHealth.keyText() + ")"));
    }

    private static String words(HealthEntry entry) {
        return (entry.severity() == Priority.CRITICAL ? "▲ " : "△ ")
                + entry.fault().text() + ", since " + SessionClock.text(entry.sinceMillis());
    }

    private static String details(HealthEntry entry) {
        String details = entry.fault().details();
        return details.isEmpty() ? "" : ". " + details;
    }

    private void colour(Optional<Priority> severity) {
        boolean critical = severity.filter(Priority.CRITICAL::equals).isPresent();
        SemanticColor text = severity.isEmpty()
                ? SemanticColor.MUTED
                : critical ? SemanticColor.ON_CRITICAL : SemanticColor.ON_WARNING;
        LookColors.background(
                this,
                severity.isEmpty()
                        ? SemanticColor.SURFACE
                        : critical ? SemanticColor.CRITICAL_FILL : SemanticColor.WARNING_FILL);
        for (JLabel label : new JLabel[] {what, advice, others}) {
            LookColors.foreground(label, text);
        }
    }
}
