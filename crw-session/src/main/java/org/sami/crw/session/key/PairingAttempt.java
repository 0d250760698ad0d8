package org.sami.crw.session.key;

import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.LinkRefusedException;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.crw.proxy.tcp.BoatPairing;

/**
 * One pairing of a boat, as a person watches it: the boat is asked by a thread of its own, then both sides show the check code, and the person says whether they
 * are equal; only then is the boat's key kept. To be used on the thread of its front, on which its listeners are called.
 */
public final class PairingAttempt {
    private final BoatPairing.Request request;
    private final BaseKeys keys;
    private final Executor front;
    private final Runnable changed;
    private State state = State.ASKING;
    private String reason = "";
    private Optional<BoatPairing> pairing = Optional.empty();
    private Optional<BoatPairing.Result> proved = Optional.empty();

    /** How it stands. */
    public enum State {
        /** The boat is asked. */
        ASKING,
        /** Both sides show the check code. */
        CHECKING,
        /** The boat's key is being kept. */
        KEEPING,
        /** The boat is paired. */
        PAIRED,
        /** It is not, for a reason in words. */
        FAILED
    }

    private PairingAttempt(BoatPairing.Request request, BaseKeys keys, Executor front, Runnable changed) {
        this.request = request;
        this.keys = keys;
        this.front = front;
        this.changed = changed;
    }

    /**
     * Begins.
     *
     * @param front runs what this tells
     * @param changed is called there after each change
     */
    public static PairingAttempt begin(BoatPairing.Request request, BaseKeys keys, Executor front, Runnable changed) {
        PairingAttempt attempt = new PairingAttempt(request, keys, front, changed);
        attempt.work(attempt::ask);
        return attempt;
    }

    private interface Work {
        void run() throws IOException;
    }

    private void work(Work work) {
        Thread thread = new Thread(
                () -> {
                    try {
                        work.run();
                    } catch (IOException fault) {
                        front.execute(() -> fail(said(fault)));
                    }
                },
                "pairing with " + request.address().getHostString());
        thread.setDaemon(true);
        thread.start();
    }

    private static String said(IOException fault) {
        return fault instanceof LinkRefusedException
                ? String.valueOf(fault.getMessage())
                : "the keys of this base: " + fault.getMessage();
    }

    private void ask() throws IOException {
        BoatPairing next = new BoatPairing(request, keys.open());
        front.execute(() -> {
            pairing = Optional.of(next);
            if (state != State.ASKING) {
                next.cancel();
            }
        });
        BoatPairing.Result result = next.prove();
        front.execute(() -> {
            if (state == State.ASKING) {
                proved = Optional.of(result);
                become(State.CHECKING);
            }
        });
    }

    private void become(State next) {
        state = next;
        changed.run();
    }

    private void fail(String why) {
        if (state != State.FAILED && state != State.PAIRED) {
            reason = why;
            become(State.FAILED);
        }
    }

    /** The person says that the boat shows the same code: its key is kept. */
    public void confirm() {
        if (state == State.CHECKING) {
            BoatPairing.Result result = proved.orElseThrow();
            BoatPairing kept = pairing.orElseThrow();
            become(State.KEEPING);
            work(() -> {
                kept.keep(result);
                front.execute(() -> become(State.PAIRED));
            });
        }
    }

    /** The person says that the boat shows another code, or none: nothing is kept here. */
    public void deny() {
        if (state == State.CHECKING) {
            fail(
                    "the codes differ, so somebody may be in between: nothing is kept here. Give up at the boat the base that"
                            + " it has just paired, and pair anew");
        }
    }

    /** Ends the waiting; nothing is kept here. */
    public void cancel() {
        pairing.ifPresent(BoatPairing::cancel);
        fail(
                state == State.CHECKING
                        ? "cancelled: nothing is kept here; the boat has kept the key of this base"
                        : "cancelled");
    }

    /** How it stands. */
    public State state() {
        return state;
    }

    /** The code that the boat shows as well; empty until it has proved itself. */
    public Optional<String> checkCode() {
        return proved.map(BoatPairing.Result::checkCode);
    }

    /** What is paired, once the boat has proved itself. */
    public Optional<BoatPairing.Result> result() {
        return proved;
    }

    /** How it stands, as one sentence without its full stop. */
    public String words() {
        String where =
                request.address().getHostString() + ":" + request.address().getPort();
        return switch (state) {
            case ASKING -> "Asking the boat at " + where;
            case CHECKING -> "Does " + name() + " show the same check code?";
            case KEEPING -> "Keeping the key of " + name();
            case PAIRED ->
                "Paired with " + name()
                        + (proved.orElseThrow().again() ? " anew" : "") + ": this base may "
                        + (proved.orElseThrow().boat().role() == Role.OBSERVER
                                ? "observe it and stop it"
                                : "command it");
            case FAILED -> "Not paired: " + reason;
        };
    }

    private String name() {
        return proved.orElseThrow().boat().name();
    }
}
