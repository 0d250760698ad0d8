package org.sami.spn.engine;

import org.sami.spn.model.Plan;
import org.sami.spn.testing.NetBuilder;

/** A parent and its child, for the tests of rules over several missions. */
final class SubMissionNets {
    /** Everybody works, then ends one by one; the instance ends with the first. */
    static final Plan CHILD = new NetBuilder("child")
            .start("c")
            .output("c", "Do")
            .end("e")
            .transition("over", "Done")
            .in("c", "over", "relevant all")
            .out("over", "e", "take all relevant")
            .build();

    /** Sends who is named by News into the child. */
    static NetBuilder parent() {
        return new NetBuilder("parent")
                .start("s")
                .transition("send", "News")
                .in("s", "send", "relevant all")
                .out("send", "sub", "take all relevant")
                .sub("sub", "child");
    }

    /** The same, and takes back who comes out. */
    static NetBuilder taking() {
        return parent().transition("back").in("sub", "back", "proxy >= 1").out("back", "x", "take all sub");
    }

    private SubMissionNets() {}
}
