package org.sami.dreamm.tree;

import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Predicate;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.StrongLabel;

/** The bar below the mission tree in which names are given: Enter takes them, Escape leaves. It is gone while nothing is asked. */
final class NameBar extends JPanel {
    private final Runnable bringUp;
    private final Runnable left;
    private final List<JTextField> fields = new ArrayList<>();

    /**
     * A bar that asks nothing.
     *
     * @param bringUp shows the panel that it is a part of
     * @param left is called when the bar is gone, for the focus
     */
    NameBar(Runnable bringUp, Runnable left) {
        super(new MigLayout("insets 8 12 8 12, wrap 2, gap 6, fillx", "[][grow, fill]"));
        this.bringUp = bringUp;
        this.left = left;
        setName("name-bar");
        setVisible(false);
        LookColors.background(this, SemanticColor.SURFACE_RAISED);
        LookColors.border(this, () -> BorderFactory.createMatteBorder(1, 0, 0, 0, SemanticColor.BORDER.get()));
        getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("ESCAPE"), "leave");
        getActionMap().put("leave", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent e) {
                leave();
            }
        });
    }

    /**
     * Asks for names.
     *
     * @param asked the fields' labels with what stands in them at first
     * @param take takes what was given; false where it was refused, and the bar stays
     */
    void ask(String title, String button, Map<String, String> asked, Predicate<List<String>> take) {
        bringUp.run();
        removeAll();
        fields.clear();
        JLabel head = new StrongLabel(title);
        head.setName("name-bar-title");
        head.setToolTipText(title);
        add(head, "span, wmin 0");
        asked.forEach((label, value) -> {
            JTextField field = new JTextField(value);
            field.setName("name-bar-" + label.toLowerCase(Locale.ROOT).replace(' ', '-'));
            field.getAccessibleContext().setAccessibleName(label);
            field.addActionListener(e -> give(take));
            add(new JLabel(label));
            add(field, "wmin 0");
            fields.add(field);
        });
        JButton give = new JButton(button);
        give.setName("name-bar-take");
        give.addActionListener(e -> give(take));
        JButton cancel = new JButton("Leave");
        cancel.setName("name-bar-leave");
        cancel.addActionListener(e -> leave());
        add(cancel, "skip, split 2, align right, growx 0, h 32!");
        add(give, "growx 0, h 32!");
        setVisible(true);
        revalidate();
        fields.get(0).requestFocusInWindow();
        fields.get(0).selectAll();
    }

    private void give(Predicate<List<String>> take) {
        List<String> given =
                fields.stream().map(field -> field.getText().strip()).toList();
        if (take.test(given)) {
            leave();
        }
    }

    private void leave() {
        setVisible(false);
        left.run();
    }
}
