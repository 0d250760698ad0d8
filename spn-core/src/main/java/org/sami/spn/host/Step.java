package org.sami.spn.host;

import java.util.List;
import org.sami.spn.protocol.Effect;

/** One input and what followed from it, kept back until its batch is durable. */
record Step(JournalEntry entry, List<Effect> effects) {}
