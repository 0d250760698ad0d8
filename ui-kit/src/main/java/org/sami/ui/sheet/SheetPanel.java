package org.sami.ui.sheet;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;
import org.sami.ui.look.StrongLabel;

/** The frame around what a sheet shows: its title and the button that closes it. */
final class SheetPanel extends JPanel {
    SheetPanel(Sheet sheet, Runnable close) {
        super(new BorderLayout());
        setName(sheet.name());
        getAccessibleContext().setAccessibleName(sheet.title().isEmpty() ? sheet.name() : sheet.title());
        if (!sheet.title().isEmpty()) {
            add(head(sheet.title(), close), BorderLayout.NORTH);
        }
        add(sheet.content());
        addMouseListener(new MouseAdapter() {}); // what is pressed here is not pressed in the panel below
        addMouseWheelListener(e -> e.consume());
        for (int when : new int[] {WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, WHEN_IN_FOCUSED_WINDOW}) {
            getInputMap(when).put(KeyStroke.getKeyStroke("ESCAPE"), "close");
        }
        getActionMap().put("close", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent pressed) {
                close.run();
            }
        });
        LookColors.background(this, SemanticColor.SURFACE);
        LookColors.border(this, () -> BorderFactory.createLineBorder(SemanticColor.ACCENT.get(), Look.px(2)));
    }

    private static JComponent head(String title, Runnable close) {
        JPanel head = new JPanel(new BorderLayout());
        JLabel words = new StrongLabel(title);
        LookColors.border(
                words,
                () -> BorderFactory.createEmptyBorder(
                        Look.px(Spacing.NORMAL), Look.px(Spacing.INSET), Look.px(Spacing.NORMAL), 0));
        head.add(words);
        JButton button = new JButton(Icons.normal("close")) {
            @Override
            public Dimension getPreferredSize() {
                int least = Look.px(Spacing.HIT_TARGET_FIELD);
                return new Dimension(least, least);
            }
        };
        button.setName("sheet-close");
        button.setToolTipText("Close (Escape)");
        button.getAccessibleContext().setAccessibleName("Close " + title);
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        button.addActionListener(e -> close.run());
        head.add(button, BorderLayout.EAST);
        return head;
    }
}
