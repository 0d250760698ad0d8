package org.sami.ui.check;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JLabel;

/**
 * The texts that a label has shown since a test began to note them. A notice leaves after 10 s, and on a busy machine more than that passes before
 * a test looks: what was shown in the meantime stands here. On the event thread.
 */
public final class LabelTexts {
    private final List<String> texts = new ArrayList<>();

    private LabelTexts() {}

    /** Notes each text that a label shows from now on; called on any thread. */
    public static LabelTexts of(JLabel label) {
        LabelTexts noted = new LabelTexts();
        return WindowRobot.ask(() -> {
            label.addPropertyChangeListener("text", change -> noted.texts.add(String.valueOf(change.getNewValue())));
            return noted;
        });
    }

    /** Whether a text with this part has been shown. */
    public boolean had(String part) {
        return texts.stream().anyMatch(text -> text.contains(part));
    }
}
