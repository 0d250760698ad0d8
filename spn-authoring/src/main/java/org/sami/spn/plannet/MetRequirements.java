package org.sami.spn.plannet;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import org.sami.spn.model.InRequirement;

/** Whether what is chosen for all tokens is what requirements ask for, and what those with numbers select. */
final class MetRequirements {
    private MetRequirements() {}

    /** Whether the named tokens of a case meet a requirement of relevant ones in a place. */
    static boolean meets(InRequirement r, String place, List<TokenOption> chosen, boolean hasTasks) {
        int here = 0;
        int named = 0;
        for (TokenOption option : chosen) {
            if (option.isNamed) {
                named++;
                here += option.present.contains(place) ? 1 : 0;
            }
        }
        return switch (r.match()) {
            case ALL -> !hasTasks || named == 0 || here > 0; // without tasks each of them was asked for alone
            case ZERO -> here == 0;
            case LESS_THAN -> here < r.n();
            case EXACTLY -> here <= r.n() && (here == r.n() || here > 0);
            case AT_LEAST -> here >= Math.min(r.n(), 1) && (here >= r.n() || here > 0);
        };
    }

    /**
     * Whether the levels of a case are what requirements with numbers select: so many, or fewer where there are no more.
     *
     * @param generics how many generic tokens each group selects
     * @param more the groups that leave generic tokens
     * @param isThere whether a token surely is where it can be selected
     * @param isLoose whether of one token several can be there, so that fewer tokens may be so many
     */
    static boolean fits(
            Map<String, List<Integer>> numbers,
            List<TokenOption> chosen,
            Map<String, Integer> generics,
            Set<String> more,
            Predicate<TokenOption> isThere,
            boolean isLoose) {
        for (Map.Entry<String, List<Integer>> group : numbers.entrySet()) {
            for (int level = 1; level <= group.getValue().size(); level++) {
                int most = group.getValue().get(level - 1);
                int picked = Math.min(generics.getOrDefault(group.getKey(), 0), most);
                boolean hasMore = more.contains(group.getKey());
                for (TokenOption option : chosen) {
                    Integer own = option.levels.get(group.getKey());
                    if (own != null && own > 0 && own <= level) {
                        picked++;
                    } else if (own != null) {
                        hasMore |= !option.isKnown || isThere.test(option) || own > level;
                    }
                }
                boolean mixes = group.getValue().size() > 1 && group.getKey().equals("ANY_TOKEN");
                if (picked > most || (picked < most && hasMore && !mixes && !(isLoose && picked > 0))) {
                    return false;
                }
            }
        }
        return true;
    }
}
