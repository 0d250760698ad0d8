package org.sami.crw.session;

import java.util.HashSet;
import java.util.NavigableSet;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.UnreachedBoat;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.session.api.FrontSession;
import org.sami.session.api.RefusedException;
import org.sami.spn.value.NaturalOrder;

/**
 * What comes of an address to which an operator connects: the boat that answers, why it is refused, or that nobody answers and why. For the models' owner, on
 * which results arrive.
 */
public final class ConnectAttempt {
    private final OperatorModels models;
    private final BoatAddress address;
    private final Set<String> knownBefore;
    private Optional<String> boat = Optional.empty();
    private Optional<String> refusal = Optional.empty();

    /** How an attempt stands. */
    public enum State {
        /** Nothing has come of it yet. */
        CONNECTING,
        /** A boat answered. */
        CONNECTED,
        /** Nobody answers; it goes on being tried. */
        NO_ANSWER,
        /** It is not tried. */
        REFUSED
    }

    private ConnectAttempt(OperatorModels models, BoatAddress address, Set<String> knownBefore) {
        this.models = Objects.requireNonNull(models, "models");
        this.address = Objects.requireNonNull(address, "address");
        this.knownBefore = Set.copyOf(knownBefore);
    }

    /**
     * Connects to an address and keeps trying.
     *
     * @param changed called when a boat has answered or was refused; {@link #state} says whether none has answered yet
     */
    public static ConnectAttempt begin(FrontSession session, BoatAddress address, Consumer<ConnectAttempt> changed) {
        Set<String> known = new HashSet<>();
        session.models().fleet().snapshot().forEach(one -> known.add(one.boat()));
        ConnectAttempt attempt = new ConnectAttempt(session.models(), address, known);
        session.fleet().connect(address).whenComplete((found, fault) -> {
            if (fault == null) {
                attempt.boat = Optional.of(found);
            } else {
                attempt.refusal = Optional.of(RefusedException.reason(fault));
            }
            changed.accept(attempt);
        });
        return attempt;
    }

    /** The address. */
    public BoatAddress address() {
        return address;
    }

    /** How it stands now. */
    public State state() {
        if (boat.isPresent()) {
            return State.CONNECTED;
        } else if (refusal.isPresent()) {
            return State.REFUSED;
        }
        return unreached().isPresent() ? State.NO_ANSWER : State.CONNECTING;
    }

    private Optional<UnreachedBoat> unreached() {
        return models.unreached().snapshot().stream()
                .filter(one -> one.address().equals(address.toString()))
                .findFirst();
    }

    /** The same in a sentence without its full stop. */
    public String words() {
        return switch (state()) {
            case CONNECTED -> connected(boat.orElseThrow());
            case REFUSED -> address + " is refused: " + refusal.orElseThrow();
            case NO_ANSWER -> unreached().orElseThrow().sentence() + "; it goes on being tried";
            case CONNECTING -> "Connecting to " + address;
        };
    }

    /** All boats that came with an address of several vehicles, as far as they have come; else the one that answered. */
    private String names(String first) {
        boolean isOfSeveral =
                address.toString().startsWith("mavlink:") && !address.toString().matches(".*/\\d+");
        NavigableSet<String> names = new TreeSet<>(NaturalOrder.INSTANCE);
        names.add(first);
        if (isOfSeveral) {
            models.fleet().snapshot().stream()
                    .map(BoatSnapshot::boat)
                    .filter(name -> name.startsWith("mav") && !knownBefore.contains(name))
                    .forEach(names::add);
        }
        return String.join(", ", names);
    }

    private String connected(String name) {
        if (knownBefore.contains(name)) {
            return address + " is " + name + ", which is connected already";
        }
        boolean watched = models.fleet()
                .boat(name)
                .map(BoatSnapshot::commander)
                .filter(BoatSnapshot.Commander.SOMEBODY_ELSE::equals)
                .isPresent();
        return address + " is connected as " + names(name)
                + (watched ? "; another base commands it, and this one watches" : "");
    }
}
