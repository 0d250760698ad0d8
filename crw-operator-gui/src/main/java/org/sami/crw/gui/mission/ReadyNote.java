package org.sami.crw.gui.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.alarm.FleetCheck;
import org.sami.crw.operator.alarm.MissingCapabilities;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.palette.SemanticColor;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;
import org.sami.ui.table.TooltipLines;

/**
 * One line that says, before a mission starts, which boats are not ready for it or cannot do all that its plan asks; its tooltip says why. It is visible only
 * while there is such a boat.
 */
final class ReadyNote extends JLabel {
    private final OperatorContext context;
    private boolean room = true;

    ReadyNote(OperatorContext context) {
        this.context = context;
        setName("plans-ready");
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

    /** Whether there is room for it; a low panel needs its own for plans. */
    void hasRoom(boolean enough) {
        if (room != enough) {
            room = enough;
            setVisible(room && !getText().isEmpty());
        }
    }

    /** The key that opens the list with the reasons, where the window has that list: one of a session elsewhere has not. */
    private String whereReasonsAre() {
        return context.commands()
                .find("boats-near")
                .map(list -> " (" + list.keyText() + " says why)")
                .orElse("");
    }

    /**
     * Says how boats are now; to be called a few times a second.
     *
     * @param plan that is selected
     * @param project with the plans of its sub-missions
     */
    void refresh(Optional<Plan> plan, Optional<Project> project) {
        List<BoatSnapshot> boats = List.copyOf(context.models().fleet().snapshot());
        FleetCheck check = FleetCheck.of(boats, context.launchFacts());
        List<String> missing = plan.flatMap(
                        chosen -> project.map(loaded -> MissingCapabilities.of(chosen, loaded, boats, context.robots())
                                .missing()))
                .orElse(List.of());
        String words = check.words();
        List<String> told = new ArrayList<>();
        if (!missing.isEmpty()) {
            told.add(missing.get(0) + (missing.size() > 1 ? "; and " + (missing.size() - 1) + " more" : ""));
        }
        if (!words.isEmpty()) {
            told.add(words + whereReasonsAre());
        }
        String text = told.isEmpty() ? "" : context.say("△ " + String.join(" · ", told));
        if (!text.equals(getText())) {
            setText(text);
            setVisible(room && !text.isEmpty());
        }
        List<String> lines = new ArrayList<>(check.reasons());
        lines.addAll(missing);
        setToolTipText(lines.isEmpty() ? null : TooltipLines.of(context.say(String.join("\n", lines))));
    }
}
