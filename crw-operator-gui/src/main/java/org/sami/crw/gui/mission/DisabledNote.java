package org.sami.crw.gui.mission;

import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import org.sami.palette.SemanticColor;
import org.sami.spn.model.DisabledParts;
import org.sami.spn.model.Plan;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;
import org.sami.ui.table.TooltipLines;

/**
 * One line that says, before a mission of a plan starts, that it does what its author has disabled for trying (docs/file-format.md). It is there as long as there
 * are such plans, whichever is selected, so that nothing moves.
 */
final class DisabledNote extends JLabel {
    /**
     * Says nothing yet, and takes no room.
     *
     * @param name of the component
     */
    DisabledNote(String name) {
        setName(name);
        LookColors.foreground(this, SemanticColor.WARNING);
        LookColors.border(this, () -> {
            int inset = Look.px(Spacing.NORMAL);
            return BorderFactory.createEmptyBorder(inset / 2, inset, inset / 2, inset);
        });
        setVisible(false);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setFont(Fonts.text());
    }

    /** Has room from now on, or has none. */
    void reserve(boolean needed) {
        setVisible(needed);
    }

    /** Says it of a plan; of none, or one that has no such parts, nothing. */
    void show(Optional<Plan> plan) {
        String warning = plan.map(DisabledParts::warning).orElse("");
        setText(warning.isEmpty() ? " " : "△ " + warning);
        setToolTipText(warning.isEmpty() ? null : TooltipLines.of(warning));
    }
}
