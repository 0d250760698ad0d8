package org.sami.crw.gui.status;

import org.sami.crw.gui.context.MachineCommand;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.session.Session;
import org.sami.crw.session.fault.BoatsAtFault;
import org.sami.ui.window.WindowSettings;

/** What boats of missions do while the engine or its journal does not work: chosen by the operator, and remembered. On the event thread. */
public final class FaultCommands {
    private static final String KEY = "on-fault";

    private final OperatorContext context;
    private final WindowSettings settings;

    /** Adds the command to those of the window, and has the session do what was chosen last. */
    public FaultCommands(OperatorContext context, WindowSettings settings) {
        this.context = context;
        this.settings = settings;
        if (settings.text(KEY).equals(BoatsAtFault.STOP.typed())) {
            session().faults().setBoats(BoatsAtFault.STOP);
        }
        context.commands().add(MachineCommand.BOATS_AT_FAULT.here(this::toggle));
    }

    private Session session() {
        return context.here();
    }

    private void toggle() {
        BoatsAtFault chosen = session().faults().boats() == BoatsAtFault.HOLD ? BoatsAtFault.STOP : BoatsAtFault.HOLD;
        session().faults().setBoats(chosen);
        settings.keep(KEY, chosen.typed());
        context.notices().show("When the engine or its journal does not work, " + chosen.words());
    }
}
