package org.sami.session.server;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.sami.crw.session.Session;
import org.sami.session.api.RefusedException;
import org.sami.session.person.Person;

/** Drives boats by hand for people who claim them. A boat whose driver falls silent gets no thrust; one whose driver leaves is given back. For the server's thread. */
final class HandDriving {
    static final long SILENCE_MS = 400;

    private final Session session;
    private final Claims claims = new Claims();
    private final PeopleNews news;
    private final Map<String, Long> drivenAtMillis = new HashMap<>();

    HandDriving(Session session, PeopleNews news) {
        this.session = session;
        this.news = news;
    }

    /** Who claims which boat. */
    Map<String, String> drivers() {
        return claims.drivers();
    }

    CompletionStage<CommandReply> carryOut(Front front, Person person, FrontMessage message)
            throws MalformedMessageException {
        String boat = message.text("boat");
        if (session.models().fleet().snapshot().stream()
                .noneMatch(one -> one.boat().equals(boat))) {
            throw new RefusedException("there is no boat '" + boat + "'");
        }
        if (message.type().equals("claim")) {
            claims.claim(boat, front);
            news.tell(person.name(), "drives " + boat + " by hand");
            return CompletableFuture.completedFuture(CommandReply.DONE);
        }
        claims.check(boat, front);
        return switch (message.type()) {
            case "drive" -> {
                CompletionStage<CommandReply> driven =
                        done(session.fleet().teleoperate(boat, message.real("thrust"), message.real("rudder")));
                drivenAtMillis.put(boat, session.scheduler().nowMs());
                yield driven;
            }
            case "goTo" -> {
                handBack(boat);
                yield session.byHand().goTo(boat, message.point()).thenApply(CommandReply::of);
            }
            case "goHome" -> {
                handBack(boat);
                yield session.byHand().goHome(boat).thenApply(CommandReply::of);
            }
            case "holdBoat" -> {
                handBack(boat);
                yield done(session.byHand().hold(boat));
            }
            default -> {
                end(boat, person.name());
                yield CompletableFuture.completedFuture(CommandReply.DONE);
            }
        };
    }

    private static <T> CompletionStage<CommandReply> done(CompletionStage<T> what) {
        return what.thenApply(result -> CommandReply.DONE);
    }

    private void handBack(String boat) {
        if (drivenAtMillis.remove(boat) != null) {
            session.fleet().teleoperate(boat, 0, 0);
            session.fleet().handBack(boat);
        }
    }

    private void end(String boat, String person) {
        handBack(boat);
        session.byHand().giveBack(boat);
        claims.release(boat);
        news.tell(person, "gave " + boat + " back");
    }

    /** A connection ended, or its person was removed or may drive no longer: the boats that it claimed are free. */
    void left(Front front) {
        claims.of(front).forEach(boat -> end(boat, front.name()));
    }

    /** Boats whose drivers are silent get no thrust. */
    void look(long nowMillis) {
        drivenAtMillis.replaceAll((boat, at) -> {
            if (at != Long.MAX_VALUE && nowMillis - at > SILENCE_MS) {
                session.fleet().teleoperate(boat, 0, 0);
                return Long.MAX_VALUE; // once is enough
            }
            return at;
        });
    }
}
