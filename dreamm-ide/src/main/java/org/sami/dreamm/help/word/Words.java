package org.sami.dreamm.help.word;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.sami.dreamm.context.BackgroundWork;
import org.sami.lessons.course.Glossary;
import org.sami.lessons.course.Term;

/** The glossary of a window, which is read where it is first asked for. On the event thread. */
final class Words {
    private final GlossaryAccess access;
    private final BackgroundWork background;
    private Optional<Glossary> glossary = Optional.empty();
    private boolean reading;

    Words(GlossaryAccess access, BackgroundWork background) {
        this.access = Objects.requireNonNull(access, "access");
        this.background = Objects.requireNonNull(background, "background");
    }

    /** Gives the terms of some words and the glossary: at once where it was read, else when it is. */
    void find(ShownText spoken, BiConsumer<Glossary, List<Term>> then) {
        whenRead(read -> then.accept(read, spoken.terms(read)));
    }

    private void whenRead(Consumer<Glossary> then) {
        if (glossary.isPresent()) {
            then.accept(glossary.get());
        } else if (!reading) {
            reading = true;
            background.run("Reading the glossary", () -> access.glossary().result(), read -> {
                reading = false;
                glossary = read;
                read.ifPresent(then);
            });
        }
    }

    /** Why one cannot go to where terms are explained; empty where one can. */
    Optional<String> whyNot() {
        return access.whyNot();
    }

    /** Goes to where a term is explained. */
    void explain(Term term) {
        access.explain(term);
    }
}
