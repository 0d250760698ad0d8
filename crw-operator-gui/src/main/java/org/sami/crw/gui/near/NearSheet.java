package org.sami.crw.gui.near;

import java.awt.Component;
import java.util.Optional;
import java.util.function.Supplier;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.key.PairSheet;
import org.sami.crw.proxy.near.BoatFinder;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.crw.session.near.NearBoats;
import org.sami.crw.session.near.NearRow;
import org.sami.ui.EventThread;
import org.sami.ui.sheet.Sheet;
import org.sami.ui.sheet.WindowSheet;

/** The sheet that lists the boats near. Boats are looked for while it is open, or while one of them is being paired from it. On the event thread. */
public final class NearSheet {
    private final OperatorContext context;
    private final Component inside;
    private final Supplier<BoatFinder> finders;
    private Optional<NearBoats> boats = Optional.empty(); // while they are looked for
    private boolean pairing;

    /**
     * A sheet of the window in which a component lies.
     *
     * @param finders begins to look for boats
     */
    public NearSheet(OperatorContext context, Component inside, Supplier<BoatFinder> finders) {
        this.context = context;
        this.inside = inside;
        this.finders = finders;
    }

    /** Opens it, and begins to look. */
    public void open() {
        close();
        pairing = false;
        NearBoats looking =
                new NearBoats(context.here(), finders.get(), BaseProtection.ofThisProcess(), EventThread.executor());
        boats = Optional.of(looking);
        show(looking);
    }

    private void show(NearBoats looking) {
        NearForm form = new NearForm(context, looking, row -> pair(looking, row));
        WindowSheet.in(inside)
                .open(new Sheet("boats-near-sheet", context.say("Boats near"), form).whenClosed(() -> left(looking)));
    }

    private void left(NearBoats looking) {
        looking.onChange(() -> {});
        if (!pairing) {
            looking.close();
        }
    }

    /** The list comes back when the pairing is left, unless something else was opened in its place. */
    private void pair(NearBoats looking, NearRow row) {
        pairing = true;
        new PairSheet(context, inside).open(row.address(), row.name(), () -> {
            pairing = false;
            if (WindowSheet.in(inside).isOpen()) {
                looking.close();
            } else {
                show(looking);
            }
        });
    }

    /** Ends the search; also with the window. */
    public void close() {
        boats.ifPresent(NearBoats::close);
        boats = Optional.empty();
    }
}
