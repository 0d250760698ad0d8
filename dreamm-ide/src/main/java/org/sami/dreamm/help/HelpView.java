package org.sami.dreamm.help;

import java.awt.Dimension;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.ScrolledPanel;
import org.sami.ui.look.Spacing;
import org.sami.ui.value.WrappedText;

/** One topic of help: what it is called, what it does, and its parts. On the event thread. */
public final class HelpView extends JPanel {
    private static final int PAGE_WIDTH = 520;
    private static final int MOST_HEIGHT = 560;

    /** The view of a topic. */
    public HelpView(HelpTopic topic) {
        super(new MigLayout("insets 0, fill", "[grow, fill]", "[grow, fill]"));
        setName("help");
        LookColors.background(this, SemanticColor.SURFACE);
        LookColors.border(this, () -> BorderFactory.createLineBorder(SemanticColor.ACCENT.get(), Look.px(2)));
        Page page = new Page(topic);
        page.setSize(Look.px(PAGE_WIDTH), Integer.MAX_VALUE);
        page.doLayout(); // texts that wrap say their height when they have a width
        page.doLayout();
        JScrollPane scrolled = page.inPane();
        scrolled.setName("help-scroll");
        add(scrolled, "wmin 0, hmin 0");
        int height = Math.min(Look.px(MOST_HEIGHT), page.getPreferredSize().height + 2 * Look.px(2));
        setPreferredSize(new Dimension(Look.px(PAGE_WIDTH), height));
    }

    private static final class Page extends ScrolledPanel {
        Page(HelpTopic topic) {
            super(new MigLayout(
                    "insets " + Spacing.INSET + ", gap 12 6, fillx, wrap 2",
                    "[" + PAGE_WIDTH / 3 + "!, fill][grow, fill]",
                    "[top]"));
            setName("help-page");
            setFocusable(true); // its scroll pane has the keys
            getAccessibleContext().setAccessibleName("Help on " + topic.title());
            getAccessibleContext().setAccessibleDescription(topic.text());
            WrappedText title = WrappedText.heading(topic.title());
            title.setName("help-title");
            add(title, "span 2, growx, wmin 0");
            add(text("help-kind", topic.kind(), SemanticColor.MUTED), "span 2, growx, wmin 0");
            if (!topic.text().isBlank()) {
                add(text("help-text", topic.text(), SemanticColor.TEXT), "span 2, growx, wmin 0, gapbottom 6");
            }
            for (HelpTopic.Detail detail : topic.details()) {
                WrappedText name = WrappedText.strong(detail.name());
                add(name, "growx, wmin 0");
                add(text("help-detail", detail.text(), SemanticColor.TEXT), "growx, wmin 0");
            }
            JLabel leave = new JLabel("Escape closes");
            leave.setName("help-leave");
            leave.setFont(Fonts.text());
            LookColors.foreground(leave, SemanticColor.MUTED);
            add(leave, "span 2, gaptop 6");
        }

        private static WrappedText text(String name, String words, SemanticColor color) {
            WrappedText text = new WrappedText(words);
            text.setName(name);
            text.setColor(color);
            return text;
        }
    }
}
