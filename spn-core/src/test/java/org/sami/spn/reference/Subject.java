package org.sami.spn.reference;

import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import java.util.Set;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Token;

/** Something that runs plans: the interpreter, the engine, or a spoilt copy of the engine. Public for the spoilt one. */
public interface Subject {
    /** Takes one input. */
    List<Effect> step(long nowMillis, Input input);

    /** Markings of all missions that have not ended; places without tokens are left out. */
    Map<Long, Map<String, List<Token>>> markings();

    /** Places with a visit by nobody that has not ended, of all missions that have not ended. */
    Map<Long, Set<String>> visitedByNobody();

    /** WAITING, RUNNING or HALTED, by mission. */
    Map<Long, String> statuses();

    /** Activations whose visits have not ended. */
    Set<Long> openActivations();

    /** Decisions that can be answered. */
    Set<Long> openDecisions();

    /** When the next timer or deadline is due. */
    OptionalLong nextDueMillis();
}
