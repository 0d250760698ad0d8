package org.sami.session.server;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import org.sami.crw.session.Session;
import org.sami.session.person.Person;
import org.sami.spn.value.GeoPoint;

/** Writes who did what into the operator's log, which the journal keeps, and sends it to all fronts. From any thread. */
final class PeopleNews {
    private final Session session;
    private final Consumer<String> toAll;

    PeopleNews(Session session, Consumer<String> toAll) {
        this.session = session;
        this.toAll = toAll;
    }

    void tell(String person, String what) {
        tell(person, what, Optional.empty());
    }

    /** Says that somebody did something when it is done. */
    <T> CompletionStage<CommandReply> noted(Person person, String done, CompletionStage<T> what) {
        return what.thenApply(result -> {
            tell(person.name(), done);
            return CommandReply.DONE;
        });
    }

    void tell(String person, String what, Optional<GeoPoint> where) {
        session.note(person + " " + what, where);
        toAll.accept(JsonNodeFactory.instance
                .objectNode()
                .put("t", "news")
                .put("at", session.scheduler().nowMs())
                .put("by", person)
                .put("text", person + " " + what)
                .toString());
    }
}
