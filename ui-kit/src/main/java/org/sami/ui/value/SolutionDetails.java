package org.sami.ui.value;

import java.awt.CardLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import net.miginfocom.swing.MigLayout;
import org.sami.spn.value.Value;

/** What solutions have in particular: of each what every entry says, and its picture where there is one. Browsing it chooses nothing. */
final class SolutionDetails {
    /** How solutions are compared side by side; the option {@code format} of the markup Selection Options. */
    enum Format {
        /** One after another, with buttons to go on and back. */
        SEQUENTIAL,
        /** On tabs. */
        TABS,
        /** One below another. */
        STACKED
    }

    private final ValueField field;
    private final Format format;
    private final List<Value> options;
    private final Function<Value, RobotWays> ways;
    private final JTabbedPane tabs = new JTabbedPane();
    private final CardLayout cards = new CardLayout();
    private final JPanel deck = new JPanel(cards);
    private final JLabel position = new JLabel(" ");
    private final JComponent component;
    private final List<JComponent> pictures = new ArrayList<>();
    private int shown;
    private Runnable turned = () -> {};

    /**
     * The details of some solutions, the first one shown.
     *
     * @param preview makes the picture of a solution, such as its paths on a map; empty where there is none
     * @param ways on which the robots of a solution would go
     */
    SolutionDetails(
            ValueField field,
            Format format,
            List<Value> options,
            Function<Value, Optional<JComponent>> preview,
            Function<Value, RobotWays> ways) {
        this.field = field;
        this.format = format;
        this.options = options;
        this.ways = ways;
        component = switch (format) {
            case TABS -> tabs;
            case SEQUENTIAL ->
                new JPanel(new MigLayout("novisualpadding, insets 0, gap 8 4, fillx", "[][grow,center][]", "[]"));
            case STACKED ->
                new JPanel(new MigLayout("novisualpadding, insets 0, gap 4 8, fillx, wrap 1", "[grow,fill]"));
        };
        component.setName(field.componentName("details"));
        if (format == Format.SEQUENTIAL) {
            if (options.size() > 1) { // one option leaves its room to what it is
                component.add(button("‹ Back", "back", -1));
                component.add(position);
                component.add(button("Next ›", "next", 1), "wrap");
            }
            component.add(deck, "span 3, grow, pushy");
            position.setName(field.componentName("position"));
            component.setOpaque(false);
            deck.setOpaque(false);
        }
        for (int i = 0; i < options.size(); i++) {
            add(i, detail(i, preview));
        }
        show(0);
        tabs.addChangeListener(event -> {
            if (tabs.getSelectedIndex() >= 0 && tabs.getSelectedIndex() != shown) {
                show(tabs.getSelectedIndex());
            }
        });
    }

    private JButton button(String words, String part, int step) {
        JButton button = new JButton(words);
        button.setName(field.componentName(part));
        button.setToolTipText("Look at another option; this chooses none");
        button.addActionListener(event -> show(Math.floorMod(shown + step, Math.max(1, options.size()))));
        return button;
    }

    private void add(int option, JComponent detail) {
        switch (format) {
            case TABS -> tabs.addTab("Option " + (option + 1), detail);
            case SEQUENTIAL -> deck.add(detail, String.valueOf(option));
            case STACKED -> component.add(detail);
        }
    }

    private JComponent detail(int option, Function<Value, Optional<JComponent>> preview) {
        List<Figures> all = options.stream().map(Figures::of).toList();
        List<String> compared = Figures.compared(all);
        Figures figures = all.get(option);
        JPanel detail = new JPanel(
                new MigLayout("novisualpadding, insets 4, gap 8 2, fillx, hidemode 3, wrap 2", "[][grow,fill]"));
        detail.setOpaque(false);
        detail.setName(field.componentName("detail-" + (option + 1)));
        if (format == Format.STACKED) {
            detail.add(new JLabel("Option " + (option + 1)), "span 2");
        }
        preview.apply(options.get(option)).ifPresent(picture -> {
            pictures.add(picture);
            detail.add(picture, "span 2, grow, hmin 140");
        });
        figures.figures().forEach((label, text) -> {
            if (!compared.contains(label)) {
                SolutionLines.line(detail, label, text);
            }
        });
        SolutionLines.add(detail, options.get(option), ways.apply(options.get(option)));
        return detail;
    }

    JComponent component() {
        return component;
    }

    /** Shows the pictures of the options, or leaves them out. */
    void showPictures(boolean visible) {
        pictures.forEach(picture -> picture.setVisible(visible));
    }

    /** Shows the details of an option. */
    void show(int option) {
        if (option >= options.size()) {
            return;
        }
        shown = option;
        if (format == Format.TABS) {
            tabs.setSelectedIndex(option);
        } else if (format == Format.SEQUENTIAL) {
            cards.show(deck, String.valueOf(option));
            position.setText("Option " + (option + 1) + " of " + options.size());
        }
        turned.run();
    }

    /** The option whose details are shown, from 0. */
    int shown() {
        return shown;
    }

    /** Calls a listener when the details of an option are shown. */
    void onShown(Runnable listener) {
        turned = listener;
    }
}
