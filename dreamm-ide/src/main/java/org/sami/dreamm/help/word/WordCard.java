package org.sami.dreamm.help.word;

import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Insets;
import java.util.List;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.sami.lessons.course.Glossary;
import org.sami.lessons.course.Term;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;
import org.sami.ui.value.WrappedText;

/** What a few terms mean, each with a link to the lesson that explains it. */
final class WordCard extends JPanel {
    private static final int WIDTH = 360;
    private static final int ICON = 16;
    private static final int PASSES = 2; // a text that wraps says its height only after it has a width

    private final transient Words words;
    private final transient Runnable close;

    /**
     * A card.
     *
     * @param tip what else the component says under the pointer; empty text for nothing
     * @param close takes the card away
     */
    WordCard(Words words, Glossary glossary, List<Term> terms, String tip, Runnable close) {
        super(new MigLayout("novisualpadding, insets 12, gap 0 4, wrap, fillx", "[grow, fill, 0:0]"));
        this.words = words;
        this.close = close;
        setName("word-card");
        LookColors.background(this, SemanticColor.SURFACE_RAISED);
        LookColors.border(this, () -> BorderFactory.createLineBorder(SemanticColor.ACCENT.get(), Look.px(1)));
        if (!tip.isEmpty()) {
            WrappedText said = new WrappedText(tip);
            said.setName("word-tip");
            said.setColor(SemanticColor.MUTED);
            add(said, "wmin 0, gapbottom 6");
        }
        for (int i = 0; i < terms.size(); i++) {
            add(glossary, terms.get(i), i == 0 ? "" : ", gaptop 8");
        }
        getAccessibleContext()
                .setAccessibleName(
                        String.join(", ", terms.stream().map(Term::term).toList()));
        fit();
    }

    private void add(Glossary glossary, Term term, String gap) {
        WrappedText title = WrappedText.strong(term.term());
        title.setName("word-term");
        add(title, "wmin 0" + gap);
        WrappedText text = new WrappedText(term.text());
        text.setName("word-text");
        add(text, "wmin 0");
        Optional<String> where = glossary.explainedIn(term);
        where.filter(heading -> words.whyNot().isEmpty())
                .ifPresent(heading -> add(link(term, heading), "wmin 0, hmin " + Spacing.HIT_TARGET));
    }

    private JButton link(Term term, String heading) {
        JButton link = new JButton(heading, Icons.of("go-to", ICON, SemanticColor.ACCENT));
        link.setName("word-go");
        link.setFont(Fonts.text());
        link.setMargin(new Insets(0, 0, 0, 0));
        link.setHorizontalAlignment(SwingConstants.LEADING);
        link.putClientProperty("JButton.buttonType", "borderless");
        link.setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
        LookColors.foreground(link, SemanticColor.ACCENT);
        link.getAccessibleContext().setAccessibleName("Go to where " + term.term() + " is explained: " + heading);
        link.addActionListener(e -> {
            close.run();
            words.explain(term);
        });
        return link;
    }

    /** Its width is given, its height what its texts need. */
    private void fit() {
        int width = Look.px(WIDTH);
        setSize(width, Integer.MAX_VALUE / 2);
        for (int i = 0; i < PASSES; i++) {
            doLayout();
        }
        setPreferredSize(new Dimension(width, getPreferredSize().height));
        setSize(getPreferredSize());
    }
}
