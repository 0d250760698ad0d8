package org.sami.dreamm.help.word;

import java.util.Optional;
import org.sami.lessons.course.Glossary;
import org.sami.lessons.course.Term;
import org.sami.spn.json.Reading;

/** The glossary of the course, and the way to where it explains a term. */
public interface GlossaryAccess {
    /** Reads the glossary; takes a moment, on any thread. */
    Reading<Glossary> glossary();

    /** Why one cannot go to where terms are explained, in a sentence; empty where one can. On the event thread. */
    Optional<String> whyNot();

    /** Goes to the step that explains a term, once nothing of what is open is lost. On the event thread. */
    void explain(Term term);
}
