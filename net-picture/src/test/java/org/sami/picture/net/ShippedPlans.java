package org.sami.picture.net;

import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Vocabulary;

/** The plans of the boats' library. */
final class ShippedPlans {
    static final String CRW = "/org/sami/domain/crw";
    static final DomainLibrary LIBRARY = DomainLibrary.fromClassPath(CRW).orThrow();
    static final Vocabulary VOCABULARY = LIBRARY.vocabulary();

    private ShippedPlans() {}

    static Plan plan(String id) {
        return LIBRARY.combined().plan(id).orElseThrow();
    }
}
