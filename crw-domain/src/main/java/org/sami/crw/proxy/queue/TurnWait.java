package org.sami.crw.proxy.queue;

import java.util.Objects;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.spn.protocol.Ids;

/**
 * Why a queued command does not have its turn.
 *
 * @param keeper the mission that keeps the boat for itself; {@code Ids.NONE} where it waits for another reason
 * @param text that reason, in words; empty where a mission keeps the boat, or where nothing waits
 */
public record TurnWait(long keeper, String text) {
    /** It has its turn. */
    public static final TurnWait NOT = new TurnWait(Ids.NONE, "");

    public TurnWait {
        Objects.requireNonNull(text, "text");
    }

    static TurnWait keptBy(long mission) {
        return new TurnWait(mission, "");
    }

    /** It waits for this reason. */
    public static TurnWait because(String text) {
        return new TurnWait(Ids.NONE, text);
    }

    /** In words; the mission is named by its number and, where it is known, by its plan. */
    public String words(MissionTitles titles) {
        return keeper == Ids.NONE ? text : titles.words(keeper) + " keeps the boat";
    }
}
