package org.sami.crw.gui.status;

import java.awt.Dimension;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.health.Health;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.spn.protocol.Priority;
import org.sami.ui.command.Command;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.SemanticColor;
import org.sami.ui.replay.SessionClock;

/**
 * The row below the strip: the worst fault that lasts, since when, what to do, and how many there are besides. It is always there, so that nothing moves when
 * a fault comes or goes; pressing it shows all faults. On the event thread.
 */
public final class HealthRow extends JButton {
    private static final String CONTENTS = "wmin 0";

    private static final int LEAST_HEIGHT = 40;
    private static final int GAP = 16;

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
        this.showHealth = showHealth;
        setLayout(new MigLayout(
                "novisualpadding, insets 0 12 0 12, gap 16", "[][grow, shrinkprio 200][shrink 0]", "push[]push"));
        setName("health-row");
        setFocusable(false);
        what.setName("health-worst");
        advice.setName("health-advice");
        others.setName("health-others");
        add(what, CONTENTS);
        add(advice, CONTENTS);
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

    /** The advice is shown whole or not at all; the tooltip and the list have it. */
    @Override
    public void doLayout() {
        int taken = what.getPreferredSize().width + others.getPreferredSize().width + Look.px(4 * GAP);
        advice.setVisible(advice.getPreferredSize().width + taken <= getWidth());
        super.doLayout();
    }

    /** As high without a fault as with one. */
    @Override
    public Dimension getPreferredSize() {
        int line = what.getFontMetrics(what.getFont()).getHeight();
        return new Dimension(0, Math.max(Look.px(LEAST_HEIGHT), line + Look.px(8)));
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
        colour(worst.map(HealthEntry::severity));
        String all = worst.map(entry -> what.getText() + ". " + entry.fault().advice())
                        .orElse("No fault of engine, journal, missions, boats or links")
                + (besides > 0 ? ". " + others.getText() : "");
        getAccessibleContext().setAccessibleName(all);
        setToolTipText(all + " – show all (" + showHealth.keyText() + ")");
    }

    private static String words(HealthEntry entry) {
        return (entry.severity() == Priority.CRITICAL ? "▲ " : "△ ")
                + entry.fault().text() + ", since " + SessionClock.text(entry.sinceMillis());
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
