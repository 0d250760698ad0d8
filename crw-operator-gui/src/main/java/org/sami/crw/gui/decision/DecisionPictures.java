package org.sami.crw.gui.decision;

import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import org.sami.crw.gui.picture.PictureStrip;
import org.sami.crw.gui.picture.ShownPictures;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandRegistry;

/** The pictures that a decision is about (markup Relevant Proxy, option showPictures), small, and the command that shows them large. */
final class DecisionPictures {
    private static final int MOST_ROWS = 3;

    private final ShownPictures pictures;
    private final PictureStrip strip;
    private final Command enlarge;

    DecisionPictures(CommandRegistry registry, ShownPictures pictures) {
        this.pictures = pictures;
        strip = new PictureStrip(pictures, MOST_ROWS);
        enlarge = registry.add(new Command("decision-pictures", "Enlarge the decision's pictures", this::open)
                .withKey("alt P")
                .withIcon("picture")
                .unless(() -> strip.first().isPresent()
                        ? Optional.empty()
                        : Optional.of("the decision that is shown has no pictures")));
    }

    JComponent component() {
        return strip;
    }

    private void open() {
        strip.first().ifPresent(pictures::open);
    }

    /** Shows those of a decision as they are now. */
    void show(Optional<PendingDecision> decision) {
        strip.show(decision.map(one -> pictures.with(one.presentation().map(), one.openedAtMillis()))
                .orElse(List.of()));
        enlarge.refresh();
    }
}
