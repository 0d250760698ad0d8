package org.sami.ui.look;

import java.util.Set;
import javax.swing.JComponent;
import javax.swing.UIManager;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicHTML;

/**
 * Has every label, button, menu item, renderer and tooltip show its text as it is written. Swing takes a text that begins with {@code <html>} as a
 * document, and fetches the pictures that it names; names of projects, plans, boats and files come from others. It stands before the look's own delegates,
 * which it asks for what they make.
 */
public final class PlainTextUI extends ComponentUI {
    private static final String DISABLE = "html.disable";
    private static final String NOTHING = "\u200B"; // has no width

    /** The delegates of all components whose text Swing would take as HTML; tabs, which heed no property, have {@link #of}. */
    private static final Set<String> DELEGATES = Set.of(
            "LabelUI",
            "ButtonUI",
            "ToggleButtonUI",
            "CheckBoxUI",
            "RadioButtonUI",
            "MenuItemUI",
            "MenuUI",
            "CheckBoxMenuItemUI",
            "RadioButtonMenuItemUI",
            "ToolTipUI");

    private PlainTextUI() {}

    /** Makes texts plain in all components that are made or get another look from now on. */
    static void install() {
        DELEGATES.forEach(delegate -> UIManager.put(delegate, PlainTextUI.class.getName()));
    }

    /** Called by Swing for each component that gets its look. */
    public static ComponentUI createUI(JComponent component) {
        component.putClientProperty(DISABLE, true);
        return UIManager.getLookAndFeelDefaults().getUI(component);
    }

    /** A title of a tab that is not taken as HTML. */
    public static String of(String title) {
        return BasicHTML.isHTMLString(title) ? NOTHING + title : title;
    }
}
