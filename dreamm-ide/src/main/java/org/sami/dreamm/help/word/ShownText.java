package org.sami.dreamm.help.word;

import java.awt.Rectangle;
import java.util.List;
import java.util.Objects;
import org.sami.lessons.course.Glossary;
import org.sami.lessons.course.Glossary.Mention;
import org.sami.lessons.course.Term;

/**
 * Words that a component shows.
 *
 * @param at the index of the character that is meant; {@link #ALL} where all of them are
 * @param box where they lie in the component
 */
public record ShownText(String text, int at, Rectangle box) {
    /** All words are meant, not one of them. */
    public static final int ALL = -1;

    private static final int MOST = 3;

    public ShownText {
        Objects.requireNonNull(text, "text");
        box = new Rectangle(box);
    }

    /** The words of a whole component. */
    public static ShownText all(String text, Rectangle box) {
        return new ShownText(text, ALL, box);
    }

    /** The same words elsewhere. */
    ShownText movedBy(int x, int y) {
        return new ShownText(text, at, new Rectangle(box.x + x, box.y + y, box.width, box.height));
    }

    /** The term that is meant, or the first few of all, each once. */
    List<Term> terms(Glossary glossary) {
        return glossary.mentions(text).stream()
                .filter(each -> at == ALL || (each.from() <= at && at < each.to()))
                .map(Mention::term)
                .distinct()
                .limit(MOST)
                .toList();
    }
}
