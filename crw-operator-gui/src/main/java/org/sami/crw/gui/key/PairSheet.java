package org.sami.crw.gui.key;

import java.awt.Component;
import java.util.Optional;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.ui.sheet.FileSheet;
import org.sami.ui.sheet.Sheet;
import org.sami.ui.sheet.WindowSheet;

/** The sheet with which a boat is paired, for every place of the window that offers it. On the event thread. */
public final class PairSheet {
    private final OperatorContext context;
    private final Component inside;

    /** A sheet of the window in which a component lies. */
    public PairSheet(OperatorContext context, Component inside) {
        this.context = context;
        this.inside = inside;
    }

    /** Opens it for whichever boat. */
    public void open() {
        open(Optional.empty(), "a boat");
    }

    /**
     * Opens it for a boat that is known by its address.
     *
     * @param name of the boat, for people
     */
    public void open(BoatAddress address, String name) {
        open(Optional.of(address), name);
    }

    private void open(Optional<BoatAddress> address, String name) {
        PairForm form = new PairForm(context, BaseProtection.ofThisProcess());
        show(form, name);
        form.begin(address);
    }

    private void show(PairForm form, String name) {
        form.choosePicture(() -> new FileSheet("pair-picture-file", "Choose a picture of the QR code")
                .open(inside, file -> {
                    show(form, name);
                    form.read(file);
                }));
        WindowSheet.in(inside).open(new Sheet("pair-sheet", "Pair " + name, form).whenClosed(form::cancel));
    }
}
