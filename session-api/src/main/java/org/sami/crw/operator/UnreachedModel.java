package org.sami.crw.operator;

import java.util.Comparator;
import java.util.List;
import java.util.function.Consumer;
import org.sami.crw.operator.boat.UnreachedBoat;

/** The addresses at which no boat has answered yet, in order. They count as boats of the fleet: a fleet of four of which one never answered is no fleet of three. */
public final class UnreachedModel extends Model<List<UnreachedBoat>> {
    private final Consumer<Runnable> inbox;
    private List<UnreachedBoat> unreached = List.of();

    UnreachedModel(Consumer<Runnable> inbox) {
        super(List.of());
        this.inbox = inbox;
    }

    /** These are all that do not answer now. From any thread. */
    public void show(List<UnreachedBoat> now) {
        List<UnreachedBoat> ordered = now.stream()
                .sorted(Comparator.comparing(UnreachedBoat::address))
                .toList();
        inbox.accept(() -> {
            unreached = ordered;
            change();
        });
    }

    /** Forgets all. */
    void clear() {
        unreached = List.of();
        change();
    }

    @Override
    List<UnreachedBoat> take() {
        return unreached;
    }
}
