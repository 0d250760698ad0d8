package org.sami.ui.look;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JRadioButton;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.JTable;
import javax.swing.JToggleButton;
import javax.swing.JToolTip;
import javax.swing.JTree;
import javax.swing.plaf.basic.BasicHTML;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.tree.DefaultTreeCellRenderer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.palette.Theme;

/** A name that looks like HTML is shown as it is written, and nothing is fetched for it. The theme is the whole process's. */
@Isolated
class PlainTextUITest {
    private static final String NAME = "<html><img src='http://127.0.0.1:9/name.png'>";

    @AfterEach
    void light() {
        Look.apply(Theme.LIGHT, 100);
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void noComponentTakesAsHtmlWhatLooksLikeIt(Theme theme) {
        Look.apply(theme, 100);
        JToolTip tip = new JToolTip();
        tip.setTipText(NAME);
        JLabel cell = (JLabel) new DefaultTableCellRenderer()
                .getTableCellRendererComponent(new JTable(1, 1), NAME, false, false, 0, 0);
        JLabel item = (JLabel) new DefaultListCellRenderer()
                .getListCellRendererComponent(new JList<>(new String[] {NAME}), NAME, 0, false, false);
        JLabel node = (JLabel) new DefaultTreeCellRenderer()
                .getTreeCellRendererComponent(new JTree(), NAME, false, false, true, 0, false);
        List<JComponent> all = List.of(
                new JLabel(NAME),
                new JButton(NAME),
                new JToggleButton(NAME),
                new JCheckBox(NAME),
                new JRadioButton(NAME),
                new JMenuItem(NAME),
                new JMenu(NAME),
                new JCheckBoxMenuItem(NAME),
                new JRadioButtonMenuItem(NAME),
                tip,
                cell,
                item,
                node);

        assertPlain(all);
        Look.apply(theme == Theme.DARK ? Theme.SUN : Theme.DARK, 150);
        all.forEach(JComponent::updateUI);
        assertPlain(all);
    }

    private static void assertPlain(List<JComponent> all) {
        assertThat(all)
                .filteredOn(one -> one.getClientProperty(BasicHTML.propertyKey) != null)
                .as("components that made HTML of a name")
                .isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {NAME, "<HTML>x", "<html>"})
    void aTitleThatLooksLikeHtmlIsWrittenSoThatItIsNone(String title) {
        assertThat(BasicHTML.isHTMLString(PlainTextUI.of(title))).isFalse();
        assertThat(PlainTextUI.of(title)).endsWith(title);
        assertThat(PlainTextUI.of("anna")).isEqualTo("anna");
    }
}
