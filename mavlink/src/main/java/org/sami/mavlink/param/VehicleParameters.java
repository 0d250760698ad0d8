package org.sami.mavlink.param;

import io.dronefleet.mavlink.common.ParamValue;
import java.io.UncheckedIOException;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.sami.mavlink.vehicle.VehicleId;

/** The parameters of one vehicle: those that were read, and what is being read or set. Used by one thread. */
public final class VehicleParameters {
    private final VehicleId vehicle;
    private final Consumer<Object> send;
    private final Consumer<SortedMap<String, Double>> keep;
    private final TreeMap<String, Exchange> exchanges = new TreeMap<>();
    private Optional<SortedMap<String, Double>> known = Optional.empty();
    private Optional<Reading> reading = Optional.empty();

    private record Exchange(ParameterExchange exchange, CompletableFuture<Double> result) {}

    private record Reading(ParameterRead read, CompletableFuture<SortedMap<String, Double>> result) {}

    /**
     * Parameters.
     *
     * @param keep receives all values each time that they are read or one changes
     * @param send sends a message of the library to the vehicle; may lose it
     */
    public VehicleParameters(VehicleId vehicle, Consumer<SortedMap<String, Double>> keep, Consumer<Object> send) {
        this.vehicle = Objects.requireNonNull(vehicle, "vehicle");
        this.keep = Objects.requireNonNull(keep, "keep");
        this.send = Objects.requireNonNull(send, "send");
    }

    /** Reads all parameters of the vehicle; fails as {@link #read} does. */
    public CompletableFuture<SortedMap<String, Double>> readAll(long nowMs) {
        if (reading.isEmpty()) {
            Reading begun = new Reading(new ParameterRead(vehicle, send), new CompletableFuture<>());
            reading = Optional.of(begun);
            begun.read().begin(nowMs);
        }
        return reading.get().result();
    }

    /** Reads one parameter of the vehicle; fails with an {@link IllegalStateException} that says in words what went wrong. */
    public CompletableFuture<Double> read(String name, long nowMs) {
        return exchange(name, Optional.empty(), nowMs);
    }

    /** Sets one parameter; the result is what the vehicle holds then, which is equal. Fails as {@link #read} does. */
    public CompletableFuture<Double> set(String name, double value, long nowMs) {
        return exchange(name, Optional.of(value), nowMs);
    }

    private CompletableFuture<Double> exchange(String name, Optional<Double> wanted, long nowMs) {
        Exchange next = new Exchange(new ParameterExchange(vehicle, name, wanted, send), new CompletableFuture<>());
        Exchange before = exchanges.put(name, next);
        if (before != null) {
            before.result()
                    .completeExceptionally(new IllegalStateException(
                            "vehicle " + vehicle + " was asked for " + name + " again before it answered"));
        }
        next.exchange().begin(nowMs);
        return next.result();
    }

    /** Takes what the vehicle sent. */
    public void take(Object message, long nowMs) {
        if (!(message instanceof ParamValue value)) {
            return;
        }
        reading.ifPresent(now -> now.read().take(value, nowMs));
        Exchange open = exchanges.get(value.paramId());
        if (open != null) {
            open.exchange().take(value, nowMs);
        }
        boolean changed = known.filter(values -> !Objects.equals(
                        values.put(value.paramId(), (double) value.paramValue()), (double) value.paramValue()))
                .isPresent();
        if (changed) { // by us or by another ground station
            known.flatMap(this::whyNotKept).ifPresent(why -> fail(open, why));
        }
        goOn();
    }

    /** Asks again where an answer is overdue. */
    public void tick(long nowMs) {
        reading.ifPresent(now -> now.read().tick(nowMs));
        exchanges.values().forEach(open -> open.exchange().tick(nowMs));
        goOn();
    }

    private void goOn() {
        exchanges.values().removeIf(open -> {
            open.exchange().value().ifPresent(open.result()::complete);
            open.exchange()
                    .failure()
                    .ifPresent(why -> open.result().completeExceptionally(new IllegalStateException(why)));
            return open.exchange().isOver();
        });
        reading.filter(now -> now.read().isOver()).ifPresent(now -> {
            reading = Optional.empty();
            now.read()
                    .failure()
                    .ifPresentOrElse(
                            why -> now.result().completeExceptionally(new IllegalStateException(why)),
                            () -> whole(now));
        });
    }

    private void whole(Reading now) {
        SortedMap<String, Double> values = now.read().values();
        known = Optional.of(values);
        whyNotKept(values)
                .ifPresentOrElse(
                        why -> now.result().completeExceptionally(new IllegalStateException(why)),
                        () -> now.result().complete(new TreeMap<>(values)));
    }

    /** Keeps values. Returns why that failed; empty if it did not. */
    private Optional<String> whyNotKept(SortedMap<String, Double> values) {
        try {
            keep.accept(values);
            return Optional.empty();
        } catch (UncheckedIOException e) {
            return Optional.of(
                    "the parameters of vehicle " + vehicle + " are known, but cannot be kept: " + e.getMessage());
        }
    }

    private static void fail(@Nullable Exchange open, String why) {
        if (open != null) {
            open.result().completeExceptionally(new IllegalStateException(why));
        }
    }

    /** Ends all that is open. */
    public void close() {
        IllegalStateException closed = new IllegalStateException("the links are closed");
        exchanges.values().forEach(open -> open.result().completeExceptionally(closed));
        exchanges.clear();
        reading.ifPresent(now -> now.result().completeExceptionally(closed));
        reading = Optional.empty();
    }
}
