package org.sami.dreamm.learn.view;

import java.awt.Component;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import org.jspecify.annotations.Nullable;
import org.sami.dreamm.help.word.ShownText;
import org.sami.dreamm.help.word.TermSource;
import org.sami.lessons.course.Paragraph;
import org.sami.lessons.course.Paragraph.Span;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;

/**
 * A paragraph that wraps, with bold words and terms of the glossary. A term shows its two sentences under the pointer, and is opened by a click; with the focus,
 * Left and Right choose a term and Enter opens it.
 */
final class TermText extends JComponent implements TermSource {
    private static final int ITEM_INDENT = 18;
    private static final double LEADING = 1.3;

    private final transient Paragraph paragraph;
    private final transient Function<String, Optional<String>> meaning;
    private final transient Consumer<String> open;
    private final transient List<Piece> pieces = new ArrayList<>();
    private final List<Integer> terms = new ArrayList<>();
    private int chosen = -1;
    private int laidOutAt = -1;
    private int height;

    /** A word with the blank behind it, or a part of a term; all words of one span have its number. */
    private record Word(String text, int span) {}

    /** A word where it lies. */
    private record Piece(Word word, Rectangle box) {}

    /**
     * A paragraph.
     *
     * @param meaning of a term, in two sentences; empty where the glossary has it not
     * @param open is given the term that was chosen
     */
    TermText(Paragraph paragraph, Function<String, Optional<String>> meaning, Consumer<String> open) {
        this.paragraph = paragraph;
        this.meaning = meaning;
        this.open = open;
        for (int i = 0; i < paragraph.spans().size(); i++) {
            if (paragraph.spans().get(i) instanceof Span.TermLink) {
                terms.add(i);
            }
        }
        setFocusable(!terms.isEmpty());
        setToolTipText(terms.isEmpty() ? null : "");
        getAccessibleContext().setAccessibleName(paragraph.words());
        listen();
    }

    private void listen() {
        key("LEFT", "previous-term", () -> choose(chosen - 1));
        key("RIGHT", "next-term", () -> choose(chosen + 1));
        key("ENTER", "open-term", () -> openSpan(chosen < 0 ? -1 : terms.get(chosen)));
        addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent e) {
                choose(Math.max(0, chosen));
            }

            @Override
            public void focusLost(FocusEvent e) {
                repaint();
            }
        });
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent e) {
                openSpan(termAt(e.getPoint()));
            }

            @Override
            public void mouseMoved(MouseEvent e) {
                setCursor(
                        termAt(e.getPoint()) < 0
                                ? Cursor.getDefaultCursor()
                                : Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
    }

    private void key(String stroke, String id, Runnable run) {
        getInputMap(WHEN_FOCUSED).put(KeyStroke.getKeyStroke(stroke), id);
        getActionMap().put(id, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent e) {
                run.run();
            }
        });
    }

    private void choose(int index) {
        chosen = Math.max(0, Math.min(terms.size() - 1, index));
        repaint();
    }

    private void openSpan(int span) {
        if (span >= 0 && paragraph.spans().get(span) instanceof Span.TermLink term) {
            open.accept(term.term());
        }
    }

    /** The span of the term at a point; -1 where there is none. */
    private int termAt(Point at) {
        wrap();
        return pieces.stream()
                .filter(piece -> piece.box().contains(at))
                .map(piece -> piece.word().span())
                .filter(terms::contains)
                .findFirst()
                .orElse(-1);
    }

    @Override
    public @Nullable String getToolTipText(MouseEvent e) {
        int span = termAt(e.getPoint());
        return span >= 0 && paragraph.spans().get(span) instanceof Span.TermLink term
                ? meaning.apply(term.term()).orElse(null)
                : null;
    }

    @Override
    public Optional<ShownText> wordsAt(Component inner, Point at) {
        int span = termAt(at);
        return span < 0
                ? Optional.empty()
                : pieces.stream()
                        .filter(piece ->
                                piece.word().span() == span && piece.box().contains(at))
                        .findFirst()
                        .map(piece -> ShownText.all(paragraph.spans().get(span).words(), piece.box()));
    }

    @Override
    public Optional<String> words() {
        return chosen < 0
                ? Optional.empty()
                : Optional.of(paragraph.spans().get(terms.get(chosen)).words());
    }

    /** Where the first word of the paragraph's so-manieth term lies, for those who drive the window. */
    Rectangle boxOfTerm(int number) {
        wrap();
        return pieces.stream()
                .filter(piece -> piece.word().span() == terms.get(number))
                .map(Piece::box)
                .findFirst()
                .orElseThrow();
    }

    private Font font(int span) {
        return paragraph.spans().get(span) instanceof Span.Bold ? Fonts.strong() : Fonts.text();
    }

    private List<Word> split() {
        List<Word> words = new ArrayList<>();
        for (int i = 0; i < paragraph.spans().size(); i++) {
            for (String part : paragraph.spans().get(i).words().split("(?<= )")) {
                words.add(new Word(part, i));
            }
        }
        return words;
    }

    /** Words that stand together without a blank are not parted: a full stop stays at its term. */
    private static List<List<Word>> unbroken(List<Word> words) {
        List<List<Word>> groups = new ArrayList<>();
        boolean open = false;
        for (Word word : words) {
            if (!open) {
                groups.add(new ArrayList<>());
            }
            groups.get(groups.size() - 1).add(word);
            open = !word.text().endsWith(" ");
        }
        return groups;
    }

    private void wrap() {
        int width = Math.max(1, getWidth());
        int key = Objects.hash(width, Look.scalePercent());
        if (key == laidOutAt) {
            return;
        }
        laidOutAt = key;
        pieces.clear();
        int indent = paragraph.isItem() ? Look.px(ITEM_INDENT) : 0;
        int line = lineHeight();
        int x = indent;
        int y = 0;
        for (List<Word> group : unbroken(split())) {
            int needed = group.stream()
                    .mapToInt(word -> width(word, word.text().stripTrailing()))
                    .sum();
            if (x > indent && x + needed > width) {
                x = indent;
                y += line;
            }
            for (Word word : group) {
                int w = width(word, word.text());
                pieces.add(new Piece(word, new Rectangle(x, y, w, line)));
                x += w;
            }
        }
        height = y + line;
    }

    private int width(Word word, String text) {
        return getFontMetrics(font(word.span())).stringWidth(text);
    }

    private int lineHeight() {
        FontMetrics metrics = getFontMetrics(Fonts.text());
        return (int) Math.ceil((metrics.getAscent() + metrics.getDescent()) * LEADING);
    }

    @Override
    public Dimension getPreferredSize() {
        wrap();
        return new Dimension(Math.max(1, getWidth()), height);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        wrap();
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        FontMetrics metrics = getFontMetrics(Fonts.text());
        int base = (lineHeight() - metrics.getAscent() - metrics.getDescent()) / 2 + metrics.getAscent();
        if (paragraph.isItem()) {
            g.setColor(SemanticColor.TEXT.get());
            int dot = Look.px(4);
            g.fillOval(Look.px(6), lineHeight() / 2 - dot / 2, dot, dot);
        }
        for (Piece piece : pieces) {
            boolean term = terms.contains(piece.word().span());
            boolean focused = term
                    && isFocusOwner()
                    && terms.get(Math.max(0, chosen)) == piece.word().span();
            g.setFont(font(piece.word().span()));
            String text = piece.word().text();
            int width = width(piece.word(), text.stripTrailing());
            if (focused) {
                g.setColor(SemanticColor.SELECTION.get());
                g.fillRect(piece.box().x, piece.box().y, width, piece.box().height);
            }
            g.setColor((focused ? SemanticColor.ON_SELECTION : term ? SemanticColor.ACCENT : SemanticColor.TEXT).get());
            g.drawString(text, piece.box().x, piece.box().y + base);
            if (term) {
                int below = piece.box().y + base + Look.px(2);
                g.drawLine(piece.box().x, below, piece.box().x + width, below);
            }
        }
        g.dispose();
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleJComponent() {
                @Override
                public AccessibleRole getAccessibleRole() {
                    return AccessibleRole.TEXT;
                }
            };
        }
        return accessibleContext;
    }

    @Override
    public String toString() {
        return paragraph.spans().stream().map(Span::words).collect(Collectors.joining());
    }
}
