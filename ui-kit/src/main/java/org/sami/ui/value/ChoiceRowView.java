package org.sami.ui.value;

import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JRadioButton;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import org.sami.ui.look.MarkIcon;

/** One row of a list of choices: its button, its number, its colour, its name and its description, of which a tooltip has the whole. A click anywhere chooses it. */
final class ChoiceRowView extends JPanel {
    private static final int NUMBERED = 9;

    private final ChoiceRow row;
    private final JToggleButton button;
    private final JLabel detail;

    ChoiceRowView(ValueField field, ChoiceRow row, int index, boolean single, Runnable chosen) {
        super(new MigLayout("novisualpadding, insets 2 4 2 4, gap 4 0, hidemode 3", "[][][grow 1]", "push[]0[]push"));
        this.row = row;
        button = single ? new JRadioButton(row.title()) : new JCheckBox(row.title());
        setOpaque(false);
        setName(field.componentName("row-" + (index + 1)));
        button.setName(field.componentName("option-" + (index + 1)));
        button.setOpaque(false);
        button.addActionListener(event -> chosen.run());
        if (index < NUMBERED) {
            button.setToolTipText("Choose with the key " + (index + 1));
        }
        JLabel chip = new JLabel();
        row.mark().ifPresent(mark -> chip.setIcon(new MarkIcon(mark)));
        chip.setVisible(row.mark().isPresent());
        add(chip);
        add(button, "growx, spanx, wrap");
        detail = new NoteLabel("");
        detail.setName(field.componentName("detail-" + (index + 1)));
        add(detail, "skip 1, growx, wmin 0, spanx, gapleft 22, gaptop 0, gapbottom 2");
        showDetail(row.detail());
        addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent event) {
                if (button.isEnabled()) {
                    button.requestFocusInWindow();
                    button.doClick(0);
                }
            }
        });
    }

    /** Shows this text next to its name from now on. */
    final void showDetail(String text) {
        if (!text.equals(detail.getText())) {
            detail.setText(text);
            setToolTipText(text.isEmpty() ? null : text); // of the row: the text itself may end with an ellipsis
            button.getAccessibleContext().setAccessibleDescription(text);
        }
        detail.setVisible(!text.isEmpty());
    }

    ChoiceRow row() {
        return row;
    }

    JToggleButton button() {
        return button;
    }
}
