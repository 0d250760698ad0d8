package org.sami.crw.gui.key;

import java.awt.Component;
import java.util.Optional;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.ui.EventThread;
import org.sami.ui.sheet.FileSheet;
import org.sami.ui.sheet.Sheet;
import org.sami.ui.sheet.WindowSheet;

/** The sheets with which boats are paired, for every place of the window that offers it. On the event thread. */
public final class PairSheet {
    private static final String PAIRING = "pair-sheet";
    private static final String PICTURE = "pair-picture-file";

    private final OperatorContext context;
    private final Component inside;

    /** A sheet of the window in which a component lies. */
    public PairSheet(OperatorContext context, Component inside) {
        this.context = context;
        this.inside = inside;
    }

    /** Opens it for whichever boat. */
    public void open() {
        open(Optional.empty(), context.say("a boat"), () -> {});
    }

    /**
     * Opens it for a boat that is known by its address.
     *
     * @param name of the boat, for people
     */
    public void open(BoatAddress address, String name) {
        open(address, name, () -> {});
    }

    /**
     * The same.
     *
     * @param then is run once the pairing is left, when the window's next sheet, if any, is open
     */
    public void open(BoatAddress address, String name, Runnable then) {
        open(Optional.of(address), name, then);
    }

    private void open(Optional<BoatAddress> address, String name, Runnable then) {
        PairForm form = new PairForm(context, BaseProtection.ofThisProcess());
        show(form, name, then);
        form.begin(address);
    }

    private void show(PairForm form, String name, Runnable then) {
        form.choosePicture(() -> new FileSheet(PICTURE, "Choose a picture of the QR code")
                .whenClosed(() -> left(then))
                .open(inside, file -> {
                    show(form, name, then);
                    form.read(file);
                }));
        WindowSheet.in(inside).open(new Sheet(PAIRING, "Pair " + name, form).whenClosed(() -> {
                    form.cancel();
                    left(then);
                }));
    }

    /** The two sheets of a pairing follow each other; which one is open is known once the first is gone. */
    private void left(Runnable then) {
        EventThread.later(() -> {
            String open = WindowSheet.in(inside).name();
            if (!open.equals(PAIRING) && !open.equals(PICTURE)) {
                then.run();
            }
        });
    }

    /** Opens the one with the code for phones, which is served as long as it is open. */
    public void addPhone() {
        PhoneForm form = new PhoneForm(context);
        WindowSheet.in(inside).open(new Sheet("phone-sheet", "Add a phone", form).whenClosed(form::close));
    }
}
