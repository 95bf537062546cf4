#pragma once
// Nothing of strike, under the name of what draws.
