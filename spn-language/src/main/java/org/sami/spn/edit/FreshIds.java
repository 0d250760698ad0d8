package org.sami.spn.edit;

import java.util.Locale;
import java.util.Set;
import org.sami.spn.model.Plan;

/** Gives ids that a plan does not have yet; each is given once. */
public final class FreshIds {
    private final Set<String> taken;

    /** Ids for new elements of a plan. */
    public FreshIds(Plan plan) {
        this.taken = Parts.ids(plan);
    }

    /** The word itself, or with a number from 2 where it is taken. */
    public String take(String word) {
        String id = Parts.freshId(taken, word);
        taken.add(id);
        return id;
    }

    /** An id made of words for people: small letters and digits, with a hyphen for what lies between. */
    public static String ofWords(String words) {
        return words.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-").replaceAll("^-|-$", "");
    }
}
