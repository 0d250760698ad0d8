package org.sami.ui.value;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.Map;
import javax.swing.JToggleButton;
import org.sami.palette.SemanticColor;

/** A button that stays down while what it stands for is chosen, and is seen from afar then. */
final class ChoiceButton extends JToggleButton {
    ChoiceButton(String words) {
        super(words);
        dress();
    }

    private void dress() {
        putClientProperty(
                FlatClientProperties.STYLE,
                Map.of(
                        "selectedBackground", SemanticColor.ACCENT.get(),
                        "selectedForeground", SemanticColor.ON_ACCENT.get()));
    }

    @Override
    public void updateUI() {
        super.updateUI();
        dress();
    }
}
