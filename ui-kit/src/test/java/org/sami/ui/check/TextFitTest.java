package org.sami.ui.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Font;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTree;
import javax.swing.tree.DefaultMutableTreeNode;
import org.junit.jupiter.api.Test;

/** The check sees what it is for: each fault is made here once, and seen. */
class TextFitTest {
    private static JPanel panel() {
        JPanel panel = new JPanel(null);
        panel.setSize(300, 100);
        return panel;
    }

    private static JLabel label(String name, int x, int width) {
        JLabel label = new JLabel("Distance to the quay");
        label.setName(name);
        label.setBounds(x, 10, width, 20);
        return label;
    }

    @Test
    void saysNothingOfTextsThatHaveRoom() {
        JPanel panel = panel();
        panel.add(label("wide", 0, 280));

        assertThat(TextFit.faults(panel)).isEmpty();
    }

    @Test
    void seesATextThatIsCut() {
        JPanel panel = panel();
        panel.add(label("narrow", 0, 40));

        assertThat(TextFit.faults(panel)).singleElement().asString().startsWith("narrow is cut");
    }

    @Test
    void seesAButtonThatIsCut() {
        JPanel panel = panel();
        JButton button = new JButton("Answer the decision");
        button.setName("answer");
        button.setBounds(0, 0, 50, 30);
        panel.add(button);

        assertThat(TextFit.faults(panel)).singleElement().asString().startsWith("answer is cut");
    }

    @Test
    void seesTextsThatLieOnOneAnother() {
        JPanel panel = panel();
        panel.add(label("one", 0, 150));
        panel.add(label("other", 100, 150));

        assertThat(TextFit.faults(panel)).containsExactly("one lies on other");
    }

    @Test
    void seesATextThatReachesOutOfItsPanel() {
        JPanel panel = panel();
        panel.add(label("outside", 200, 200));

        assertThat(TextFit.faults(panel))
                .singleElement()
                .asString()
                .startsWith("outside at 200,10 of 200 x 20 reaches out");
    }

    @Test
    void seesATextThatIsTooSmall() {
        JPanel panel = panel();
        JLabel small = label("small", 0, 280);
        small.setFont(small.getFont().deriveFont(Font.PLAIN, 9f));
        panel.add(small);

        assertThat(TextFit.faults(panel)).singleElement().asString().startsWith("small is smaller than 12 px");
    }

    @Test
    void seesACellThatIsCut() {
        JTable table = new JTable(new Object[][] {{"a text that needs some room", "x"}}, new Object[] {"A", "B"});
        table.setName("table");
        table.setRowHeight(24);
        table.setSize(160, 24);
        table.doLayout();
        JPanel panel = panel();
        panel.add(table);

        assertThat(TextFit.faults(panel)).singleElement().asString().startsWith("table cuts row 0, column 0");
    }

    @Test
    void seesARowOfAListThatIsCut() {
        JList<String> list = new JList<>(new String[] {"a name that needs a lot of room to be read"});
        list.setName("names");
        JScrollPane pane = new JScrollPane(list);
        Layout.layOut(pane, 90, 60);

        assertThat(TextFit.faults(pane)).singleElement().asString().startsWith("names cuts row 0");
    }

    @Test
    void seesAShortenedRowWithoutATooltip() {
        JTree tree = new JTree(new DefaultMutableTreeNode("a na…ead"));
        tree.setName("tree");
        JScrollPane pane = new JScrollPane(tree);
        Layout.layOut(pane, 200, 60);

        assertThat(TextFit.faults(pane)).singleElement().asString().startsWith("tree has no tooltip");
    }

    @Test
    void looksAtWhatScrollsInFull() {
        JPanel inner = panel();
        inner.add(label("far", 0, 280));
        inner.setPreferredSize(inner.getSize());
        JScrollPane pane = new JScrollPane(inner);
        Layout.layOut(pane, 100, 60);

        assertThat(TextFit.faults(pane)).isEmpty();
    }
}
