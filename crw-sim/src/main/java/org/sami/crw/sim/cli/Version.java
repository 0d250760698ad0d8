package org.sami.crw.sim.cli;

import picocli.CommandLine.IVersionProvider;

/** The version of the build, from the jar's manifest. */
final class Version implements IVersionProvider {
    @Override
    public String[] getVersion() {
        String built = Crw.class.getPackage().getImplementationVersion();
        return new String[] {
            "crw " + (built == null ? "(not packaged)" : built),
            "Java " + System.getProperty("java.version") + ", " + System.getProperty("os.name")
        };
    }
}
